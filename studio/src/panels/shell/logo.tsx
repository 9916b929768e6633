// The mark: a mountain that stands in the sea, seen with what lies under the water.
export function Logo() {
  return (
    <svg class="logo" viewBox="0 0 24 24" width="22" height="22" role="img" aria-label="Seamount">
      <path class="logo-land" d="M12 3.5 L16.2 11 H7.8 Z" />
      <path class="logo-sea" d="M7 12.6 H17 L22 21 H2 Z" />
    </svg>
  );
}
