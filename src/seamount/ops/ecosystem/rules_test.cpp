#include "seamount/ops/ecosystem/rules.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "seamount/ops/ecosystem/test_scene.h"

namespace seamount::ecosystem {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::Field;
using testing::HasSubstr;
using testing::IsEmpty;

auto defect(const std::string& pointer, const std::string& message) {
  return ElementsAre(
      AllOf(Field(&CatalogueDefect::pointer, pointer), Field(&CatalogueDefect::message, HasSubstr(message))));
}

Catalogue sound() {
  Catalogue catalogue;
  catalogue.materials = {material("sand"), material("rubble")};
  catalogue.classes = {region("island", "1"), curve("reef", "sand - distance(island)"), point("coral", "depth * sand")};
  catalogue.classes[2].deposits = {{"rubble", 1.0, 5.0}};
  return catalogue;
}

TEST(Rules, AreCompiledFromASoundCatalogue) {
  const Catalogue catalogue = sound();
  EXPECT_THAT(find_defects(catalogue), IsEmpty());
  const Rules rules = compile(catalogue);
  ASSERT_EQ(rules.classes.size(), 3U);
  EXPECT_THAT(rules.classes[2].deposits, ElementsAre(1));
  EXPECT_EQ(rules.classes[1].fitting.terms(), rules.classes[1].fitness.terms()) << "empty: the fitness";
}

TEST(Rules, NameWhatIsWrongWithItsPlace) {
  Catalogue bad = sound();
  bad.classes[1].fitness = "sand - distance(iland)";
  EXPECT_THAT(find_defects(bad),
              defect("/classes/1/fitness", "column 17: unknown class 'iland', did you mean 'island'?"));
  bad = sound();
  bad.classes[0].name = "0sle";
  bad.classes[1].fitness = "1";
  EXPECT_THAT(find_defects(bad), defect("/classes/0/name", "is no name"));
  bad = sound();
  bad.materials[1].name = "depth";
  bad.classes[2].deposits.clear();
  EXPECT_THAT(find_defects(bad), defect("/materials/1/name", "a word of expressions already"));
  bad = sound();
  bad.classes[2].name = "reef";
  EXPECT_THAT(find_defects(bad), defect("/classes", "'reef' is there twice"));
  bad = sound();
  bad.classes[2].deposits[0].material = "rubbel";
  EXPECT_THAT(find_defects(bad), defect("/classes/2/deposits/0/material", "did you mean 'rubble'?"));
  bad = sound();
  bad.classes[2].placement.within = {"reef"};
  EXPECT_THAT(find_defects(bad), defect("/classes/2/placement/within/0", "only regions"));
}

TEST(Rules, RefuseWhatCanNeverLive) {
  Catalogue bad = sound();
  bad.classes[2].death = 2.0;
  EXPECT_THAT(find_defects(bad), defect("/classes/2/death", "it would die as it is born"));
  bad = sound();
  bad.classes[2].placement.within = bad.classes[2].placement.outside = {"island"};
  EXPECT_THAT(find_defects(bad), defect("/classes/2/placement/outside", "could be nowhere"));
  bad = sound();
  bad.classes.push_back(region("lagoon", "1"));
  bad.classes[0].placement.within = {"lagoon"};
  bad.classes[3].placement.within = {"island"};
  EXPECT_THAT(find_defects(bad), testing::SizeIs(2));
  bad.classes[3].placement.within = {"island", "lagoon"};
  EXPECT_THAT(find_defects(bad), testing::SizeIs(2));
  bad.classes.push_back(region("sea", "1"));
  bad.classes[3].placement.within.push_back("sea");
  EXPECT_THAT(find_defects(bad), IsEmpty()) << "a lagoon may begin in the sea, islands then in the lagoon";
}

TEST(Rules, PutMaterialsInTheOrderOfTheirTransformations) {
  Catalogue catalogue = sound();
  catalogue.materials.push_back(material("silt"));
  catalogue.transformations = {{"sand", "silt", 0.1, 1.0}, {"rubble", "sand", 0.1, 1.0}};
  EXPECT_THAT(compile(catalogue).material_order, ElementsAre(1, 0, 2));
  catalogue.transformations.push_back({"silt", "rubble", 0.1, 1.0});
  EXPECT_THAT(find_defects(catalogue), defect("/transformations", "may not form a ring"));
  catalogue.transformations = {{"sand", "sand", 0.1, 1.0}};
  EXPECT_THAT(find_defects(catalogue), defect("/transformations", "may not form a ring"));
}

TEST(Rules, BearAThousandClasses) {
  Catalogue catalogue;
  for (int i = 0; i < 1000; ++i) catalogue.classes.push_back(point("class" + std::to_string(i), "distance(class0)"));
  EXPECT_THAT(find_defects(catalogue), IsEmpty());
}

}  // namespace
}  // namespace seamount::ecosystem
