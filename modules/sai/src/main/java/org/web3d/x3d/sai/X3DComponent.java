package org.web3d.x3d.sai;

/** A browser within the window of a program. */
public interface X3DComponent {
  /** The browser of the component. */
  ExternalBrowser getBrowser();

  /**
   * What to put into the window, for example an AWT component; its type is the browser's affair.
   */
  Object getImplementation();

  /** Ends the component and its browser and lets all that they hold go. */
  void shutdown();
}
