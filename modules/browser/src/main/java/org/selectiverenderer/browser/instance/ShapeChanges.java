package org.selectiverenderer.browser.instance;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * A log of the shapes of an {@link InstanceTree} that have moved, changed or come to be shown, in
 * that order; a shape may be in it several times. Readers remember up to where they have read, so
 * that a frame in which little changes costs little, however many shapes there are. Old entries are
 * forgotten, and all of them when the tree's structure changes.
 */
public final class ShapeChanges {
  /** The number of entries that a reader can rely on; at most twice as many are kept. */
  private static final int KEPT = 1 << 16;

  private final List<ShapeInstance> latest = new ArrayList<>();
  private long forgotten;

  ShapeChanges() {}

  /** Returns the number of entries since the tree was made. */
  public long end() {
    return forgotten + latest.size();
  }

  /**
   * Returns the entries from a former {@link #end} on; empty if some of them are forgotten, so that
   * any shape may have changed. The list is valid until the tree changes.
   */
  public Optional<List<ShapeInstance>> since(long end) {
    return end < forgotten
        ? Optional.empty()
        : Optional.of(latest.subList((int) (end - forgotten), latest.size()));
  }

  void add(ShapeInstance shape) {
    if (latest.size() == 2 * KEPT) {
      latest.subList(0, KEPT).clear();
      forgotten += KEPT;
    }
    latest.add(shape);
  }

  /** Forgets all entries, so that every reader looks at all shapes. */
  void forget() {
    forgotten = end() + 1;
    latest.clear();
  }
}
