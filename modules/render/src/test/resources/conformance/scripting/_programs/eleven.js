function initialize() {
  out = 11;
}
