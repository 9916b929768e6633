# The studio's page: what ./run studio and ./test build it with. Needs tools/setup.sh and packages/studio.txt.

# build_page: the studio's page into studio/dist/page, where something of it has changed.
build_page() {
  (
    cd studio || exit
    if [[ package-lock.json -nt node_modules/.package-lock.json ]]; then
      say "seamount: fetching what the studio's page is built with"
      npm ci --no-audit --no-fund --loglevel=error >&2 || exit
      touch node_modules/.package-lock.json
    fi
    [[ -e dist/page/index.html && ! $(find src examples build.mjs package-lock.json -newer dist/page/index.html) ]] || node build.mjs
  )
}
