package org.selectiverenderer.enricher;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.selectiverenderer.authoring.file.CrashRecovery;
import org.selectiverenderer.base.trust.TrustStore;
import org.selectiverenderer.x3d.url.ContentAccessPolicy;

/**
 * The windows of this process. Each has a document of its own, and no file is open in two of them;
 * they share the settings and the folder of the recovery copies. For the event dispatch thread.
 */
final class EnricherWindows {
  private static final int OFFSET = 28;

  private final AppearanceSettings look;
  private final CrashRecovery recovery;
  private final TrustStore trust;
  private final Runnable closed;
  private final List<EnricherWindow> open = new ArrayList<>();

  /**
   * @param folder of the user's settings
   * @param access folders and hosts that scenes may read from, in addition to those of the settings
   * @param closed runs when the last window is closed
   */
  EnricherWindows(Path folder, ContentAccessPolicy access, Runnable closed) {
    this.look = AppearanceSettings.remembered(folder, access);
    this.recovery = new CrashRecovery(folder.resolve("recovery"));
    this.trust = new TrustStore(folder);
    this.closed = closed;
  }

  AppearanceSettings look() {
    return look;
  }

  CrashRecovery recovery() {
    return recovery;
  }

  TrustStore trust() {
    return trust;
  }

  /** Adds a window that has been created. */
  void add(EnricherWindow window) {
    if (!open.isEmpty()) { // not exactly over the one before
      var last = open.get(open.size() - 1).frame();
      window.frame().setLocation(last.getX() + OFFSET, last.getY() + OFFSET);
    }
    open.add(window);
  }

  /** Removes a window that has been closed. */
  void remove(EnricherWindow window) {
    if (open.remove(window) && open.isEmpty()) {
      closed.run();
    }
  }

  /** The windows in the order in which they were opened. */
  List<EnricherWindow> all() {
    return List.copyOf(open);
  }

  /** Opens a scene in a new window, or brings the window to the front that has it. */
  void openNew(Path scene) {
    Optional<EnricherWindow> having = open.stream().filter(each -> each.has(scene)).findFirst();
    if (having.isPresent()) {
      toFront(having.get());
    } else {
      EnricherWindow window = new EnricherWindow(this);
      window.show();
      window.open(scene);
    }
  }

  /**
   * Brings another window to the front that has a file.
   *
   * @return whether there is such a window
   */
  boolean showOther(Path file, EnricherWindow besides) {
    Optional<EnricherWindow> having =
        open.stream().filter(each -> each != besides && each.has(file)).findFirst();
    having.ifPresent(EnricherWindows::toFront);
    return having.isPresent();
  }

  /** Opens a file that the system hands over, in the first window if it is empty. */
  void receive(Path file) {
    if (open.size() == 1 && open.get(0).session().isEmpty()) {
      open.get(0).open(file);
    } else {
      openNew(file);
    }
  }

  private static void toFront(EnricherWindow window) {
    window.frame().setState(java.awt.Frame.NORMAL);
    window.frame().toFront();
    window.frame().requestFocus();
  }
}
