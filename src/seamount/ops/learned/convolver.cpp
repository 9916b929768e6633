#include "seamount/ops/learned/convolver.h"

#include <dlfcn.h>

#include <algorithm>
#include <map>
#include <mutex>
#include <oneapi/dnnl/dnnl.hpp>
#include <utility>
#include <vector>

namespace seamount::learned {
namespace {

using dnnl::memory;

/// oneDNN counts on OpenMP for its threads: while this lives, it finds one, the caller. Elsewhere in the program the
/// number stays what it was. Looked up by name, since oneDNN brought the OpenMP library along.
class OneThread {
 public:
  OneThread() : before_(functions().get != nullptr ? functions().get() : 0) {
    if (before_ > 1) functions().set(1);
  }
  ~OneThread() {
    if (before_ > 1) functions().set(before_);
  }
  OneThread(const OneThread&) = delete;
  OneThread& operator=(const OneThread&) = delete;

 private:
  struct Functions {
    int (*get)();
    void (*set)(int);
  };
  static const Functions& functions() {
    static const Functions found = [] {
      const auto get = reinterpret_cast<int (*)()>(dlsym(RTLD_DEFAULT, "omp_get_max_threads"));
      const auto set = reinterpret_cast<void (*)(int)>(dlsym(RTLD_DEFAULT, "omp_set_num_threads"));
      return get != nullptr && set != nullptr ? Functions{get, set} : Functions{nullptr, nullptr};
    }();
    return found;
  }

  int before_;
};

const dnnl::engine& engine() {
  static const dnnl::engine processor(dnnl::engine::kind::cpu, 0);
  return processor;
}

dnnl::stream& stream() {
  thread_local dnnl::stream own(engine());
  return own;
}

/// Scratch memory of a thread, as much as any call needed.
void* scratch(size_t bytes) {
  thread_local std::vector<std::byte> own;
  if (own.size() < bytes + 64) own.resize(bytes + 64);
  return own.data() + (64 - reinterpret_cast<uintptr_t>(own.data()) % 64) % 64;
}

memory::data_type type_of(bool bf16) { return bf16 ? memory::data_type::bf16 : memory::data_type::f32; }

dnnl::primitive_attr attributes(After after) {
  dnnl::post_ops operations;
  if (after == After::add_relu) operations.append_sum(1.0F);
  if (after != After::nothing) operations.append_eltwise(1.0F, dnnl::algorithm::eltwise_relu, 0.0F, 0.0F);
  dnnl::primitive_attr attributes;
  attributes.set_post_ops(operations);
  attributes.set_scratchpad_mode(dnnl::scratchpad_mode::user);
  return attributes;
}

}  // namespace

bool has_bf16() {
  const auto have = static_cast<unsigned>(dnnl::get_effective_cpu_isa());
  const auto need = static_cast<unsigned>(dnnl::cpu_isa::avx512_core_bf16);
  return (have & need) == need;
}

struct Convolver::Prepared {
  memory::dim outs, ins, rows, columns;  ///< of the weights
  memory::dim stride;
  After after;
  bool bf16, f32_out;
  memory weight, bias;  ///< as they were given, in f32

  /// The call for bands of one size, with the weights in the order that it wants.
  struct Call {
    memory::desc in, out, scratch;
    dnnl::convolution_forward call;
    memory weight;
  };
  std::mutex mutex;
  std::map<std::pair<int, int>, Call> calls;  ///< by width and rows
  std::vector<memory> orders;                 ///< the weights in all orders that any call wants

  const Call& call_for(int width, int count);
  Call make(int width, int count);
  memory ordered(const memory::desc& wanted);
};

const Convolver::Prepared::Call& Convolver::Prepared::call_for(int width, int count) {
  const std::lock_guard lock(mutex);
  const auto found = calls.find({width, count});
  if (found != calls.end()) return found->second;
  return calls.emplace(std::pair(width, count), make(width, count)).first->second;
}

Convolver::Prepared::Call Convolver::Prepared::make(int width, int count) {
  const memory::dim left = columns == 3 ? 1 : 0, out_width = columns == 2 ? width - 1 : width / stride;
  const memory::dim right = (out_width - 1) * stride + columns - width - left;
  const memory::desc in({1, ins, stride * (count - 1) + rows, width}, type_of(bf16), memory::format_tag::nhwc);
  const memory::desc out({1, outs, count, out_width}, type_of(bf16 && !f32_out), memory::format_tag::nhwc);
  const memory::desc any(weight.get_desc().dims(), type_of(bf16), memory::format_tag::any);
  const dnnl::convolution_forward::desc wanted(dnnl::prop_kind::forward_inference, dnnl::algorithm::convolution_direct,
                                               in, any, bias.get_desc(), out, {stride, stride}, {0, left}, {0, right});
  const dnnl::convolution_forward::primitive_desc chosen(wanted, attributes(after), engine());
  return {in, out, chosen.scratchpad_desc(), dnnl::convolution_forward(chosen), ordered(chosen.weights_desc())};
}

memory Convolver::Prepared::ordered(const memory::desc& wanted) {
  for (const memory& order : orders) {
    if (order.get_desc() == wanted) return order;
  }
  memory order(wanted, engine());
  dnnl::reorder(weight, order).execute(stream(), weight, order);
  stream().wait();
  orders.push_back(order);
  return order;
}

Convolver::Convolver(const Tensor& weight, const Tensor& bias, int stride, After after, bool bf16, bool f32_out)
    : prepared_(new Prepared{weight.shape[0],
                             weight.shape[1],
                             weight.shape[2],
                             weight.shape[3],
                             stride,
                             after,
                             bf16,
                             f32_out,
                             {},
                             {},
                             {},
                             {},
                             {}}) {
  const auto memory_of = [](const Tensor& tensor, memory::format_tag order) {
    memory out({tensor.shape, memory::data_type::f32, order}, engine());
    std::copy(tensor.values.begin(), tensor.values.end(), static_cast<float*>(out.get_data_handle()));
    return out;
  };
  prepared_->weight = memory_of(weight, memory::format_tag::oihw);
  prepared_->bias = memory_of(bias, memory::format_tag::x);
}
Convolver::Convolver(Convolver&&) noexcept = default;
Convolver& Convolver::operator=(Convolver&&) noexcept = default;
Convolver::~Convolver() = default;

int Convolver::out_channels() const { return static_cast<int>(prepared_->outs); }
double Convolver::work() const {
  return static_cast<double>(prepared_->outs * prepared_->ins * prepared_->rows * prepared_->columns);
}

void Convolver::run(const void* in, int width, int rows, void* out) const {
  const OneThread one;
  const Prepared::Call& call = prepared_->call_for(width, rows);
  call.call.execute(stream(),
                    {{DNNL_ARG_SRC, memory(call.in, engine(), const_cast<void*>(in))},
                     {DNNL_ARG_WEIGHTS, call.weight},
                     {DNNL_ARG_BIAS, prepared_->bias},
                     {DNNL_ARG_DST, memory(call.out, engine(), out)},
                     {DNNL_ARG_SCRATCHPAD, memory(call.scratch, engine(), scratch(call.scratch.get_size()))}});
  stream().wait();
}

}  // namespace seamount::learned
