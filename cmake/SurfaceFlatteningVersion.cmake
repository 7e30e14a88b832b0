# The one place of the version; CHANGELOG.md says what it has.
set(SURFACEFLATTENING_VERSION 0.1.0)
