package org.selectiverenderer.radiosity.parallel;

/**
 * Listens to the progress of a radiosity computation and can cancel it. Called from several
 * threads.
 */
public interface RadiosityProgress {
  /** Ignores progress and never cancels. */
  RadiosityProgress NONE =
      new RadiosityProgress() {
        @Override
        public void at(Stage stage, double share) {
          // Nobody listens.
        }

        @Override
        public boolean cancelled() {
          return false;
        }
      };

  /**
   * The stages of the computation, each with its share of the time in a scene of many polygons.
   * Light is gathered either at vertices, after subdivision, or at texels.
   */
  enum Stage {
    READING("reading", 0, 0.05),
    TRANSPORT("form factors", 0.05, 0.2),
    ITERATIONS("iterations", 0.25, 0.03),
    SUBDIVISION("subdivision", 0.28, 0.07),
    GATHERING("light at the vertices", 0.35, 0.6),
    TEXELS("light at the texels", 0.28, 0.67),
    WRITING("writing", 0.95, 0.05);

    private final String label;
    private final double before;
    private final double weight;

    Stage(String label, double before, double weight) {
      this.label = label;
      this.before = before;
      this.weight = weight;
    }

    public String label() {
      return label;
    }

    /**
     * Returns the share of the whole computation that is done when a share of this stage is done.
     */
    public double overall(double share) {
      return before + weight * share;
    }
  }

  /**
   * @param share share of the stage that is done, 0 .. 1
   */
  void at(Stage stage, double share);

  boolean cancelled();
}
