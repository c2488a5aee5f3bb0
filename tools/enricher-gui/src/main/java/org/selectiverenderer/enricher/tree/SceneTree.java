package org.selectiverenderer.enricher.tree;

import java.awt.Color;
import java.awt.Cursor;
import java.awt.Graphics;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.event.KeyEvent;
import java.awt.event.MouseEvent;
import java.util.List;
import java.util.Optional;
import javax.swing.JTree;
import javax.swing.SwingUtilities;
import javax.swing.Timer;
import javax.swing.UIManager;
import javax.swing.tree.TreePath;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * A tree of nodes in which selected rows can be dragged: between rows and onto rows, with Ctrl as
 * copies. While dragging, the place is marked, and a refused one is explained in the status bar;
 * Escape ends it.
 *
 * <p>The drag is one of the mouse within the tree, not of the desktop: rows are moved, whereas a
 * desktop's drag would have to send them as text and could not tell where they came from.
 */
final class SceneTree extends JTree {
  private static final long serialVersionUID = 1L;
  private static final int FARNESS = 6;
  private static final int OPENS_AFTER = 700;

  private final transient SceneTreeModel scene;
  private final transient EnricherSession session;
  private final transient DropTargets targets = new DropTargets(this);
  private final Timer opening = new Timer(OPENS_AFTER, event -> openHovered());
  private transient @Nullable NodeDrop drop;
  private transient @Nullable Point pressed;
  private transient List<DocumentElement> dragged = List.of();
  private transient DropTargets.@Nullable Target target;
  private transient @Nullable TreePath hovered;
  private transient boolean refused;
  private transient boolean collapsing;

  SceneTree(SceneTreeModel scene, EnricherSession session) {
    super(scene);
    this.scene = scene;
    this.session = session;
    opening.setRepeats(false);
    setAutoscrolls(true);
  }

  /** Sets what moves the nodes; without it nothing can be dragged. */
  void onDrop(NodeDrop does) {
    drop = does;
  }

  @Override
  protected void processMouseEvent(MouseEvent event) {
    switch (event.getID()) {
      case MouseEvent.MOUSE_PRESSED -> {
        pressed = null;
        collapsing = false;
        if (SwingUtilities.isLeftMouseButton(event) && isEnabled() && onRow(event)) {
          pressed = event.getPoint();
          int row = getRowForLocation(event.getX(), event.getY());
          boolean plain = !event.isControlDown() && !event.isShiftDown() && !event.isMetaDown();
          if (plain && isRowSelected(row) && getSelectionCount() > 1) {
            // Only the release selects this row alone, so that all can be dragged.
            collapsing = true;
            requestFocusInWindow();
            return;
          }
        }
      }
      case MouseEvent.MOUSE_RELEASED -> {
        if (!dragged.isEmpty()) {
          finish(event);
          return;
        }
        if (collapsing) {
          setSelectionRow(getRowForLocation(event.getX(), event.getY()));
        }
        pressed = null;
        collapsing = false;
      }
      default -> {}
    }
    super.processMouseEvent(event);
  }

  private boolean onRow(MouseEvent event) {
    return getRowForLocation(event.getX(), event.getY()) >= 0;
  }

  @Override
  protected void processMouseMotionEvent(MouseEvent event) {
    Point from = pressed;
    if (event.getID() == MouseEvent.MOUSE_DRAGGED && from != null && drop != null) {
      if (dragged.isEmpty() && from.distance(event.getPoint()) >= FARNESS) {
        begin();
      }
      if (!dragged.isEmpty()) {
        follow(event.getPoint(), event.isControlDown());
        return;
      }
    }
    super.processMouseMotionEvent(event);
  }

  @Override
  protected void processKeyEvent(KeyEvent event) {
    if (!dragged.isEmpty() && event.getID() == KeyEvent.KEY_PRESSED) {
      if (event.getKeyCode() == KeyEvent.VK_ESCAPE) {
        end();
        session.message("");
      }
      event.consume();
      return;
    }
    super.processKeyEvent(event);
  }

  private void begin() {
    if (scene.flat()) {
      session.message(Texts.of("node.dragFlat"));
      pressed = null;
      return;
    }
    dragged = session.selectedElements().stream().filter(DocumentElement::attached).toList();
  }

  private void follow(Point at, boolean copy) {
    scrollRectToVisible(new Rectangle(at.x, at.y - getRowHeight(), 1, 2 * getRowHeight()));
    NodeDrop does = drop;
    if (does == null) {
      return;
    }
    List<DropTargets.Target> possible = targets.at(at.y);
    Optional<DropTargets.Target> fits =
        possible.stream()
            .filter(each -> does.complaint(dragged, each.position(), copy).isEmpty())
            .findFirst();
    refused = fits.isEmpty();
    target = fits.orElse(possible.isEmpty() ? null : possible.get(0));
    setCursor(Cursor.getPredefinedCursor(refused ? Cursor.DEFAULT_CURSOR : Cursor.MOVE_CURSOR));
    DropTargets.Target now = target;
    if (now != null) {
      session.message(
          refused
              ? does.complaint(dragged, now.position(), copy).orElse("")
              : Texts.of(
                  copy ? "node.dragCopy" : now.into() ? "node.dragInto" : "node.dragBetween",
                  now.position().parent().toString()));
    }
    TreePath over = targets.path(at.y).orElse(null);
    if (over != null && !over.equals(hovered)) {
      hovered = over;
      opening.restart();
    }
    repaint();
  }

  private void openHovered() {
    if (!dragged.isEmpty() && hovered != null) {
      expandPath(hovered);
    }
  }

  private void finish(MouseEvent event) {
    follow(event.getPoint(), event.isControlDown());
    NodeDrop does = drop;
    DropTargets.Target at = refused ? null : target;
    List<DocumentElement> nodes = dragged;
    end();
    if (does != null && at != null) {
      does.drop(nodes, at.position(), event.isControlDown());
    }
  }

  private void end() {
    opening.stop();
    dragged = List.of();
    target = null;
    hovered = null;
    pressed = null;
    collapsing = false;
    setCursor(null);
    repaint();
  }

  @Override
  protected void paintComponent(Graphics g) {
    super.paintComponent(g);
    DropTargets.Target now = target;
    if (now == null) {
      return;
    }
    Color wrong = refused ? UIManager.getColor("Component.error.focusedBorderColor") : null;
    g.setColor(wrong == null ? getForeground() : wrong);
    Rectangle mark = now.mark();
    if (now.into()) {
      g.drawRect(mark.x - 1, mark.y, mark.width + 1, mark.height - 1);
      g.drawRect(mark.x, mark.y + 1, mark.width - 1, mark.height - 3);
    } else {
      g.fillRect(mark.x, mark.y, mark.width, mark.height);
    }
  }
}
