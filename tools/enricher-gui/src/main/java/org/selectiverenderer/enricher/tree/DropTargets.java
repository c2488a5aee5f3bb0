package org.selectiverenderer.enricher.tree;

import java.awt.Rectangle;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javax.swing.JTree;
import javax.swing.tree.TreePath;
import org.selectiverenderer.authoring.structure.ChildPosition;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * Finds what a place in a tree means for nodes that are dropped there: the middle of a row stands
 * for the element itself, its edges for the places before and after it.
 */
final class DropTargets {
  private static final int LINE = 2;

  private final JTree tree;

  DropTargets(JTree tree) {
    this.tree = tree;
  }

  /**
   * A place for nodes.
   *
   * @param mark what is painted: the row of the element into which they go, or a line between rows
   * @param into whether they go into the element of a row
   */
  record Target(ChildPosition position, Rectangle mark, boolean into) {}

  /** Returns the targets at a height in the tree, the one that is meant first. */
  List<Target> at(int y) {
    List<Target> targets = new ArrayList<>();
    int rows = tree.getRowCount();
    if (rows == 0) {
      return targets;
    }
    int row = tree.getClosestRowForLocation(0, y);
    Rectangle bounds = tree.getRowBounds(row);
    if (!(tree.getPathForRow(row).getLastPathComponent() instanceof DocumentElement element)
        || !element.attached()) {
      return targets;
    }
    boolean below = y >= bounds.y + bounds.height;
    int part = below ? 3 : Math.max(0, (y - bounds.y) * 4 / Math.max(1, bounds.height));
    Target into = new Target(ChildPosition.last(element), bounds, true);
    Optional<Target> before =
        element
            .parent()
            .map(
                parent ->
                    new Target(
                        new ChildPosition(parent, parent.children().indexOf(element)),
                        line(bounds, 0),
                        false));
    Optional<Target> after = after(element, row, bounds);
    switch (part) {
      case 0 -> {
        before.ifPresent(targets::add);
        targets.add(into);
      }
      case 1 -> {
        targets.add(into);
        before.ifPresent(targets::add);
        after.ifPresent(targets::add);
      }
      case 2 -> {
        targets.add(into);
        after.ifPresent(targets::add);
        before.ifPresent(targets::add);
      }
      default -> {
        after.ifPresent(targets::add);
        targets.add(into);
      }
    }
    return targets;
  }

  /** Returns the place below a row: before the first child of an open element, else behind it. */
  private Optional<Target> after(DocumentElement element, int row, Rectangle bounds) {
    Rectangle line = line(bounds, bounds.height);
    return tree.isExpanded(row) && !element.children().isEmpty()
        ? Optional.of(new Target(new ChildPosition(element, 0), line, false))
        : element.parent().map(parent -> new Target(ChildPosition.after(element), line, false));
  }

  private Rectangle line(Rectangle row, int down) {
    return new Rectangle(row.x, row.y + down - 1, Math.max(1, tree.getWidth() - row.x), LINE);
  }

  /** Returns the path of the row at a height. */
  Optional<TreePath> path(int y) {
    return Optional.ofNullable(tree.getClosestPathForLocation(0, y));
  }
}
