package org.selectiverenderer.radiosity.work;

/** Hears how far the work is and says whether it is still wanted; called from several threads. */
public interface WorkProgress {
  /** Nobody listens, nobody cancels. */
  WorkProgress NONE =
      new WorkProgress() {
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
   * The parts of the work, each with its share of the time in a scene of many polygons. Light goes
   * either to vertices, after subdivision, or to texels.
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

    /** The share of all work that is done when this stage is done so far. */
    public double overall(double share) {
      return before + weight * share;
    }
  }

  /**
   * @param share of the stage that is done, 0 .. 1
   */
  void at(Stage stage, double share);

  boolean cancelled();
}
