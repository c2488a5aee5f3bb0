package org.selectiverenderer.browser.script;

/**
 * The time that all scripts together may take. Each call has a limit of its own, but scripts
 * trigger each other, make further scripts, and replace the scene by one that begins anew. Time
 * used at one time stamp becomes available again while the scene's time goes on; a scene that
 * replaces another continues with what that one has left.
 */
public final class ScriptTimeBudget {
  /** The seconds that all calls together may take at one time stamp. */
  private static final int MOST_CALLING = 10;

  /** The seconds that all scripts together may take to start at one time stamp. */
  private static final int MOST_STARTING = 10;

  /**
   * The seconds that become available again in one second of the scene's time. A scene whose
   * scripts take longer than that cannot be shown; it must not be simulated for hours either.
   */
  private static final int REGAINED_PER_SECOND = 4;

  private final Used calling;
  private final Used starting;

  /** Creates the budget that docs/scripts.md tells. */
  public ScriptTimeBudget() {
    this(MOST_CALLING, MOST_STARTING);
  }

  /**
   * @param calling the seconds that all calls together may take at one time stamp
   * @param starting the seconds that all scripts together may take to start at one time stamp
   */
  ScriptTimeBudget(double calling, double starting) {
    this.calling = new Used(calling);
    this.starting = new Used(starting);
  }

  /** Returns the time for calls of scripts that have started. */
  Used calling() {
    return calling;
  }

  /** Returns the time for first statements and {@code initialize}. */
  Used starting() {
    return starting;
  }

  /** The time used of one kind. */
  static final class Used {
    private final double most;
    private double stamp = Double.NaN;
    private double seconds;

    Used(double most) {
      this.most = most;
    }

    /**
     * Adds the time of a call that has ended.
     *
     * @param at the time stamp
     * @param took the duration of the call in seconds
     * @return whether this call exceeds the budget
     */
    boolean add(double at, double took) {
      boolean before = over(at);
      seconds += took;
      return !before && over(at);
    }

    /** Returns the seconds that may be used at one time stamp. */
    double most() {
      return most;
    }

    /** Returns whether the budget is used up at a time stamp. */
    boolean over(double at) {
      if (at != stamp) {
        double passed = at > stamp ? at - stamp : 0;
        seconds = Math.max(0, seconds - passed * REGAINED_PER_SECOND);
        stamp = at;
      }
      return seconds > most;
    }
  }
}
