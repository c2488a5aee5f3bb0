package org.selectiverenderer.runtime.sai;

import java.util.concurrent.CopyOnWriteArrayList;
import org.selectiverenderer.base.problem.Location;
import org.selectiverenderer.runtime.World;
import org.selectiverenderer.runtime.scene.ApplicationCode;
import org.web3d.x3d.sai.BrowserEvent;
import org.web3d.x3d.sai.BrowserListener;

/** The listeners of a browser's events, in the order of their registration. Thread-safe. */
final class BrowserListeners {
  private final World world;
  private final CopyOnWriteArrayList<BrowserListener> listeners = new CopyOnWriteArrayList<>();

  BrowserListeners(World world) {
    this.world = world;
  }

  void add(BrowserListener listener) {
    listeners.addIfAbsent(listener);
  }

  void remove(BrowserListener listener) {
    listeners.remove(listener);
  }

  void clear() {
    listeners.clear();
  }

  void tell(BrowserEvent event) {
    for (BrowserListener listener : listeners) {
      ApplicationCode.call(
          world.problems(),
          Location.of(world.scene().url()),
          "a browser listener",
          () -> listener.browserChanged(event));
    }
  }
}
