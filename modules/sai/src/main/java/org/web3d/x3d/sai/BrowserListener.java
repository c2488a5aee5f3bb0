package org.web3d.x3d.sai;

import java.util.EventListener;

/** Hears what happens to a browser. */
public interface BrowserListener extends EventListener {
  /** Something happened; {@link BrowserEvent#getID()} says what. */
  void browserChanged(BrowserEvent event);
}
