package org.selectiverenderer.enricher.plan;

import java.awt.Cursor;
import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import java.awt.geom.Rectangle2D;
import java.util.Optional;
import java.util.OptionalDouble;
import javax.swing.SwingUtilities;
import org.joml.Vector3d;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.authoring.area.AreaBox;
import org.selectiverenderer.authoring.area.AreaInstance;
import org.selectiverenderer.enricher.area.AreaCommands;
import org.selectiverenderer.enricher.area.FloorPlanImage;
import org.selectiverenderer.enricher.area.GridSetting;
import org.selectiverenderer.enricher.area.NodeCommands;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.geometry.BoundingBox;

/**
 * Handles the mouse in the plan: dragging over the ground draws an area, dragging an area moves it,
 * dragging a handle resizes it; the right or middle button pans, the wheel zooms.
 */
final class PlanMouseController extends MouseAdapter {
  /** Pixels that the mouse may move during a click. */
  private static final int STILL = 4;

  /** Distance in pixels within which an edge snaps to a wall. */
  private static final double PULL = 8;

  private static final double NEARER_PER_NOTCH = 1.15;

  private final FloorPlanCanvas view;
  private final EnricherSession session;
  private final AreaCommands commands;
  private final NodeCommands nodes;
  private final GridSetting grid;
  private final PlanMenu menu;
  private final PlanObjects objects;

  /** Whether the objects have taken the press of the button. */
  private boolean taken;

  /** The area that was selected when the button was pressed. */
  private Optional<AreaInstance> before = Optional.empty();

  private int pressX;
  private int pressY;
  private int lastX;
  private int lastY;
  private boolean shifting;
  private boolean dragged;
  private boolean ended;
  private @Nullable AreaInstance area;
  private @Nullable PlanDrag drag;

  PlanMouseController(
      FloorPlanCanvas view,
      EnricherSession session,
      AreaCommands commands,
      GridSetting grid,
      PlanMenu menu,
      PlanObjects objects) {
    this.view = view;
    this.session = session;
    this.commands = commands;
    this.nodes = commands.nodes();
    this.grid = grid;
    this.menu = menu;
    this.objects = objects;
    view.addMouseListener(this);
    view.addMouseMotionListener(this);
    view.addMouseWheelListener(this);
    view.addFocusListener(
        new FocusAdapter() {
          @Override
          public void focusGained(FocusEvent event) {
            view.repaint();
          }

          @Override
          public void focusLost(FocusEvent event) {
            view.repaint();
          }
        });
  }

  /**
   * Whether areas can be edited: not before the plan image is there, as the author would not see
   * the rooms.
   */
  private boolean writable() {
    return view.picture().isPresent()
        && session.document().locked().isEmpty()
        && session.document().fault().isEmpty();
  }

  private Optional<AreaInstance> at(double x, double y) {
    return view.hitOrder().stream()
        .filter(each -> view.scale().rectangle(FloorPlanCanvas.bounds(each)).contains(x, y))
        .findFirst();
  }

  /** Returns the resize handle of the selected area at a pixel, as its sides on X and Z. */
  private Optional<int[]> grip(double x, double y) {
    Optional<AreaInstance> selected = view.selected().filter(each -> !each.frame().turned());
    if (selected.isEmpty()) {
      return Optional.empty();
    }
    Rectangle2D place = view.scale().rectangle(FloorPlanCanvas.bounds(selected.get()));
    for (int sideX = -1; sideX <= 1; sideX++) {
      for (int sideZ = -1; sideZ <= 1; sideZ++) {
        Rectangle2D grip = FloorPlanCanvas.grip(place, sideX, sideZ);
        grip.setFrame(grip.getX() - 2, grip.getY() - 2, grip.getWidth() + 4, grip.getHeight() + 4);
        if ((sideX != 0 || sideZ != 0) && grip.contains(x, y)) {
          return Optional.of(new int[] {sideX, sideZ});
        }
      }
    }
    return Optional.empty();
  }

  @Override
  public void mouseMoved(MouseEvent event) {
    int kind =
        grip(event.getX(), event.getY())
            .map(PlanMouseController::cursor)
            .orElseGet(
                () ->
                    objects.handle(event.getX(), event.getY()).isPresent()
                            || at(event.getX(), event.getY()).isPresent()
                        ? Cursor.MOVE_CURSOR
                        : Cursor.CROSSHAIR_CURSOR);
    if (view.getCursor().getType() != kind) {
      view.setCursor(Cursor.getPredefinedCursor(kind));
    }
  }

  private static int cursor(int[] sides) {
    int[][] kinds = {
      {Cursor.NW_RESIZE_CURSOR, Cursor.W_RESIZE_CURSOR, Cursor.SW_RESIZE_CURSOR},
      {Cursor.N_RESIZE_CURSOR, Cursor.MOVE_CURSOR, Cursor.S_RESIZE_CURSOR},
      {Cursor.NE_RESIZE_CURSOR, Cursor.E_RESIZE_CURSOR, Cursor.SE_RESIZE_CURSOR}
    };
    return kinds[sides[0] + 1][sides[1] + 1];
  }

  @Override
  public void mousePressed(MouseEvent event) {
    view.requestFocusInWindow();
    cancel();
    pressX = event.getX();
    pressY = event.getY();
    lastX = pressX;
    lastY = pressY;
    dragged = false;
    ended = false;
    shifting = !SwingUtilities.isLeftMouseButton(event);
    before = view.selected();
    Optional<int[]> grip = grip(pressX, pressY);
    taken = !shifting && grip.isEmpty() && objects.press(event);
    if (shifting || taken || !writable()) {
      return;
    }
    double x = view.scale().x(pressX);
    double z = view.scale().z(pressY);
    if (grip.isPresent()) {
      area = view.selected().orElseThrow();
      drag = new PlanDrag(FloorPlanCanvas.bounds(area), grip.get()[0], grip.get()[1], x, z);
    } else {
      at(pressX, pressY)
          .ifPresent(
              hit -> {
                area = hit;
                drag = new PlanDrag(FloorPlanCanvas.bounds(hit), 0, 0, x, z);
                session.select(hit.element(), view);
              });
    }
  }

  private PlanDrag.Snapping snapping(double x, double z, boolean free) {
    return new PlanDrag.Snapping() {
      @Override
      public double at(int axis, double value) {
        return free ? value : near(axis, value).orElseGet(() -> grid.step().nearest(value));
      }

      @Override
      public boolean wall(int axis, double value) {
        return !free && near(axis, value).isPresent();
      }

      private OptionalDouble near(int axis, double value) {
        double across = axis == 0 ? z : x;
        return grid.walls() && view.picture().isPresent()
            ? new WallSnapper(view.picture().get())
                .wall(axis, value, across, PULL / view.scale().scale())
            : OptionalDouble.empty();
      }
    };
  }

  @Override
  public void mouseDragged(MouseEvent event) {
    dragged |= Math.hypot(event.getX() - pressX, event.getY() - pressY) > STILL;
    if (!dragged || ended) {
      return;
    }
    if (shifting) {
      view.scale(view.scale().shifted(event.getX() - lastX, event.getY() - lastY));
      lastX = event.getX();
      lastY = event.getY();
      return;
    }
    boolean free = event.isAltDown();
    double x = view.scale().x(event.getX());
    double z = view.scale().z(event.getY());
    if (taken) {
      objects.drag(event, snapping(x, z, free));
      return;
    }
    if (!writable()) {
      return;
    }
    PlanDrag of = drag;
    if (of != null) {
      view.drawing(of.at(x, z, snapping(x, z, free)), area);
    } else {
      double fromX = view.scale().x(pressX);
      double fromZ = view.scale().z(pressY);
      PlanDrag.Snapping from = snapping(fromX, fromZ, free);
      PlanDrag.Snapping to = snapping(x, z, free);
      view.drawing(
          PlanDrag.between(
              from.at(0, fromX),
              from.at(1, fromZ),
              to.at(0, x),
              to.at(1, z),
              view.picture().map(FloorPlanImage::cut).orElse(0.0)),
          null);
    }
  }

  @Override
  public void mouseReleased(MouseEvent event) {
    Optional<BoundingBox> done = view.drawing();
    AreaInstance changed = area;
    PlanDrag of = drag;
    boolean still = !dragged;
    if (taken && !ended) {
      taken = false;
      objects.release(event, still);
      return;
    }
    cancel();
    if (ended) {
      return;
    }
    if (shifting) {
      if (still && SwingUtilities.isRightMouseButton(event)) {
        Optional<AreaInstance> hit = at(event.getX(), event.getY());
        if (hit.isPresent()) {
          session.select(hit.get().element(), view);
          menu.show(event.getX(), event.getY());
        } else {
          objects.select(event, () -> menu.show(event.getX(), event.getY()));
        }
      }
    } else if (done.isPresent() && changed != null && of != null) {
      boolean moving = of.sideX() == 0 && of.sideZ() == 0;
      nodes.place(changed.element(), placed(changed, of, done.get()), moving ? "move" : "resize");
    } else if (done.isPresent()) {
      draw(done.get());
    } else if (still && (changed == null || again(changed))) {
      objects.click(event, false);
    }
  }

  /** Whether an area was selected already, so that a click means what is under it. */
  private boolean again(AreaInstance area) {
    return before.filter(each -> each.element() == area.element()).isPresent();
  }

  /** Returns the box after a drag; a rotated area is only moved. */
  private static AreaBox placed(AreaInstance area, PlanDrag drag, BoundingBox now) {
    Vector3d shift =
        new Vector3d(now.minX() - drag.start().minX(), 0, now.minZ() - drag.start().minZ());
    return area.frame().turned() || drag.sideX() == 0 && drag.sideZ() == 0
        ? area.box().movedBy(shift)
        : AreaBox.of(now);
  }

  /**
   * Creates an area over a rectangle, from the floor to the ceiling there. The rectangle stays
   * visible until the author has named the area or cancelled.
   */
  void draw(BoundingBox rectangle) {
    if (rectangle.width() >= PlanDrag.LEAST && rectangle.depth() >= PlanDrag.LEAST) {
      view.drawing(rectangle, null);
      commands
          .probe()
          .raised(
              rectangle,
              found -> {
                try {
                  found.ifPresent(bounds -> commands.add(AreaBox.of(bounds)));
                } finally {
                  if (view.drawing().equals(Optional.of(rectangle))) {
                    view.drawing(null, null); // Else the author already draws another one.
                  }
                }
              });
    }
  }

  /** Cancels the drag; mouse events are ignored until the button is released. */
  void takeBack() {
    ended = view.drawing().isPresent() || taken;
    if (objects.settings().measuring()) {
      objects.settings().measure(false);
    }
    cancel();
  }

  private void cancel() {
    objects.cancel();
    area = null;
    drag = null;
    view.drawing(null, null);
  }

  @Override
  public void mouseWheelMoved(MouseWheelEvent event) {
    view.scale(
        view.scale()
            .zoomed(
                Math.pow(NEARER_PER_NOTCH, -event.getPreciseWheelRotation()),
                event.getX(),
                event.getY()));
  }

  /** Snaps the edges of areas to the walls of a plan. */
  static final class WallSnapper {
    /** Least length of a wall segment that counts, in metres. */
    private static final double WALL = 0.2;

    /** Largest slope of a wall that counts as parallel to an axis. */
    private static final double STRAIGHT = 0.01;

    private final float[] walls;

    WallSnapper(FloorPlanImage picture) {
      walls = picture.walls();
    }

    /**
     * Returns the coordinate of the nearest wall; empty if none is near.
     *
     * @param axis 0 for X, 1 for Z
     * @param value coordinate of the edge on that axis
     * @param across coordinate of the pointer on the other axis
     * @param near largest distance in metres
     */
    OptionalDouble wall(int axis, double value, double across, double near) {
      OptionalDouble best = OptionalDouble.empty();
      double least = near;
      for (int i = 0; i + 3 < walls.length; i += 4) {
        double from = walls[i + axis];
        double to = walls[i + 2 + axis];
        double along = walls[i + 1 - axis];
        double end = walls[i + 3 - axis];
        double length = Math.abs(end - along);
        double distance = Math.abs((from + to) / 2 - value);
        boolean wall = length >= WALL && Math.abs(to - from) <= STRAIGHT * length;
        boolean here = across >= Math.min(along, end) - 1 && across <= Math.max(along, end) + 1;
        if (wall && here && distance < least) {
          least = distance;
          best = OptionalDouble.of((from + to) / 2);
        }
      }
      return best;
    }
  }
}
