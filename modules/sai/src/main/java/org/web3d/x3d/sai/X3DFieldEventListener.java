package org.web3d.x3d.sai;

import java.util.EventListener;

/** Hears the events that a field sends. */
public interface X3DFieldEventListener extends EventListener {
  /** The field sent an event. Called on the thread of the browser; it should return soon. */
  void readableFieldChanged(X3DFieldEvent event);
}
