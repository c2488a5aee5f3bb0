package org.web3d.x3d.sai;

import java.util.EventObject;

/** Says that something happened to a browser; its source is the browser. */
public class BrowserEvent extends EventObject {
  /** A world is loaded and its first frame is about to be made. */
  public static final int INITIALIZED = 0;

  /** The present world is about to go. */
  public static final int SHUTDOWN = 1;

  /** None of the addresses given to the browser could be loaded. */
  public static final int URL_ERROR = 2;

  /** The connection to a browser in another process broke. */
  public static final int CONNECTION_ERROR = 10;

  /** Numbers up to this one belong to the standard; a browser may use those above. */
  public static final int LAST_IDENTIFIER = 100;

  private static final long serialVersionUID = 1L;

  /** What has happened: one of the constants. */
  private final int id;

  /**
   * An event.
   *
   * @param source the browser
   * @param id what happened, one of the constants or a number of the browser's own
   */
  public BrowserEvent(Object source, int id) {
    super(source);
    this.id = id;
  }

  /** What happened, one of the constants or a number of the browser's own. */
  public int getID() {
    return id;
  }
}
