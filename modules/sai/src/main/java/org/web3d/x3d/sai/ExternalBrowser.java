package org.web3d.x3d.sai;

/** A browser as a program outside of the scene sees it. */
public interface ExternalBrowser extends Browser {
  /**
   * Holds back writes to fields until {@link #endUpdate()}, so that all take effect at the same
   * time. Calls do not nest: the first end releases everything.
   */
  void beginUpdate() throws InvalidBrowserException;

  /** Lets the writes since {@link #beginUpdate()} take effect. */
  void endUpdate() throws InvalidBrowserException;

  /** Calls the listener when something happens; one that is there already is not added again. */
  void addBrowserListener(BrowserListener listener) throws InvalidBrowserException;

  /** Ends the calls; without effect if the listener is not there. */
  void removeBrowserListener(BrowserListener listener) throws InvalidBrowserException;

  /** Ends the use of the browser; every later call throws {@link InvalidBrowserException}. */
  void dispose();
}
