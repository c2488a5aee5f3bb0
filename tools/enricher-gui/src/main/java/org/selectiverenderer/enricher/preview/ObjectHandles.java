package org.selectiverenderer.enricher.preview;

import java.awt.event.KeyAdapter;
import java.awt.event.KeyEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.Supplier;
import javax.swing.SwingUtilities;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.authoring.area.SnapGrid;
import org.selectiverenderer.authoring.placement.Placement;
import org.selectiverenderer.browser.instance.ShapeInstance;
import org.selectiverenderer.enricher.area.AsyncSceneQueries;
import org.selectiverenderer.enricher.area.ObjectBox;
import org.selectiverenderer.enricher.placement.HandleSettings;
import org.selectiverenderer.enricher.placement.PlacementCommands;
import org.selectiverenderer.enricher.placement.PlacementDrag;
import org.selectiverenderer.enricher.session.EnricherSession;

/**
 * The handles that move, turn and scale the selected objects in the picture. A drag shows the
 * objects in the running scene only, with their boxes; releasing the mouse makes one edit. Escape
 * cancels the drag; Alt turns snapping off. It receives mouse events before {@link
 * PreviewInputController} and consumes those that it uses; a click on a handle is left to what is
 * behind it.
 */
final class ObjectHandles extends MouseAdapter {
  private static final double REACH = 7;

  /** Distance that the mouse may move during a click. */
  private static final int STILL = 3;

  private final PreviewCanvas view;
  private final EnricherSession session;
  private final PreviewThread thread;
  private final SourceAnchorResolver anchors;
  private final AsyncSceneQueries probe;
  private final PlacementCommands commands;
  private final Supplier<SnapGrid> grid;
  private final Consumer<MouseEvent> clicked;
  private @Nullable HandleSettings settings;
  private @Nullable ObjectHandle hot;
  private @Nullable ObjectHandleDrag drag;
  private ObjectHandleDrag.@Nullable Dragged dragged;
  private OptionalDouble floor = OptionalDouble.empty();
  private boolean moved;
  private boolean takenBack;
  private int pressX;
  private int pressY;
  private long asked;

  /** The boxes after an edit, until a picture shows it. */
  private List<ObjectBox> expected = List.of();

  private long expectedRevision = -1;

  /**
   * @param clicked receives clicks on handles, which are meant for what is behind
   */
  ObjectHandles(
      PreviewCanvas view,
      EnricherSession session,
      PreviewThread thread,
      SourceAnchorResolver anchors,
      AsyncSceneQueries probe,
      Supplier<SnapGrid> grid,
      Consumer<MouseEvent> clicked) {
    this.view = view;
    this.session = session;
    this.thread = thread;
    this.anchors = anchors;
    this.probe = probe;
    this.grid = grid;
    this.clicked = clicked;
    commands = new PlacementCommands(session, probe);
    view.addMouseListener(this);
    view.addMouseMotionListener(this);
    view.addKeyListener(
        new KeyAdapter() {
          @Override
          public void keyPressed(KeyEvent event) {
            if (event.getKeyCode() == KeyEvent.VK_ESCAPE && drag != null) {
              cancel();
              event.consume();
            }
          }
        });
    ObjectHandlePainter painter = new ObjectHandlePainter(view);
    view.overlay(
        (g, frame) ->
            painter.paint(
                g, new PictureRays(frame.camera()), boxes(frame), handles(frame), hot, words()));
  }

  /** Sets what the handles do; without, there are none. */
  void settings(HandleSettings use) {
    settings = use;
    use.onChange(view::repaint);
    view.repaint();
  }

  private Optional<String> words() {
    return Optional.ofNullable(dragged).map(ObjectHandleDrag.Dragged::words);
  }

  /** The boxes to be outlined: those of the drag, or of several selected nodes. */
  private List<ObjectBox> boxes(PreviewFrame frame) {
    ObjectHandleDrag now = drag;
    if (now != null && dragged != null) {
      return now.objects().boxes(dragged.placements());
    }
    return current(frame);
  }

  /** The boxes of the selected nodes in the present document; none while they are not known. */
  private List<ObjectBox> current(PreviewFrame frame) {
    long revision = session.document().revision();
    if (frame.revision() == revision) {
      return frame.boxes();
    }
    return expectedRevision == revision ? expected : List.of();
  }

  private Optional<PlacementDrag> objects(PreviewFrame frame) {
    HandleSettings use = settings;
    if (use == null || use.measuring() || frame.walking()) {
      return Optional.empty();
    }
    boolean area = session.selection().filter(each -> each.name().endsWith("Sensor")).isPresent();
    return area ? Optional.empty() : commands.drag(current(frame));
  }

  private List<ObjectHandle> handles(PreviewFrame frame) {
    if (drag != null) {
      return List.of();
    }
    return objects(frame)
        .map(of -> ObjectHandle.of(of, mode(), new PictureRays(frame.camera()), view.scale()))
        .orElse(List.of());
  }

  private HandleSettings.Mode mode() {
    return settings == null ? HandleSettings.Mode.MOVE : settings.mode();
  }

  private double x(MouseEvent event) {
    return (event.getX() - view.left()) * view.scale();
  }

  private double y(MouseEvent event) {
    return event.getY() * view.scale();
  }

  private @Nullable ObjectHandle at(MouseEvent event) {
    if (x(event) < 0 || view.frame().isEmpty()) {
      return null;
    }
    ObjectHandle found = null;
    double nearest = REACH * view.scale();
    for (ObjectHandle handle : handles(view.frame().get())) {
      double distance = handle.distance(x(event), y(event));
      if (distance < nearest) {
        nearest = distance;
        found = handle;
      }
    }
    return found;
  }

  @Override
  public void mouseMoved(MouseEvent event) {
    ObjectHandle before = hot;
    hot = at(event);
    if (hot == null ? before != null : before == null || !hot.same(before)) {
      view.repaint();
    }
  }

  @Override
  public void mousePressed(MouseEvent event) {
    takenBack = false;
    hot = event.isConsumed() ? null : at(event);
    boolean plain = !event.isControlDown() && !event.isShiftDown();
    if (hot == null || !plain || !SwingUtilities.isLeftMouseButton(event)) {
      return;
    }
    PreviewFrame frame = view.frame().orElseThrow();
    Optional<PlacementDrag> objects = objects(frame);
    if (objects.isEmpty()) {
      return;
    }
    view.requestFocusInWindow();
    moved = false;
    dragged = null;
    floor = OptionalDouble.empty();
    pressX = event.getX();
    pressY = event.getY();
    ObjectHandleDrag begun =
        new ObjectHandleDrag(
            objects.get(), hot, new PictureRays(frame.camera()), x(event), y(event));
    drag = begun;
    event.consume();
    probe.support(
        objects.get().items().stream().map(PlacementDrag.Item::box).toList(),
        heights -> {
          if (drag == begun && heights.size() == 1) {
            floor = heights.get(0);
          }
        });
  }

  @Override
  public void mouseDragged(MouseEvent event) {
    ObjectHandleDrag of = drag;
    if (takenBack || of != null) {
      event.consume();
    }
    if (of == null) {
      return;
    }
    moved |= Math.hypot(event.getX() - pressX, event.getY() - pressY) > STILL;
    if (!moved) {
      return;
    }
    boolean free = event.isAltDown();
    SnapGrid step = free ? SnapGrid.NONE : grid.get();
    if (of.handle().kind() == ObjectHandle.Kind.SURFACE && !free) {
      overSurface(of, event, step);
    } else {
      show(of, of.at(x(event), y(event), step, free, floor));
    }
  }

  /** Asks for the surface under the mouse; the newest answer places the objects on it. */
  private void overSurface(ObjectHandleDrag of, MouseEvent event, SnapGrid step) {
    long number = ++asked;
    double px = x(event);
    double py = y(event);
    Vector3d eye = new Vector3d();
    Vector3d sight = of.rays().sight(px, py, eye);
    List<SelectedNode> own =
        anchors.nodes(of.objects().items().stream().map(item -> item.placement().node()).toList());
    thread.ask(
        stage -> {
          Optional<Vector3dc> point =
              stage
                  .scene()
                  .flatMap(
                      scene -> {
                        ObjectQueries queries = new ObjectQueries(scene);
                        Set<ShapeInstance> through = queries.shapes(own);
                        return queries.hit(eye, sight, through);
                      })
                  .map(hit -> hit.point());
          SwingUtilities.invokeLater(
              () -> {
                if (drag == of && number == asked) {
                  show(
                      of,
                      point
                          .map(at -> of.on(at, step))
                          .orElseGet(() -> of.at(px, py, step, false, floor)));
                }
              });
        });
  }

  private void show(ObjectHandleDrag of, ObjectHandleDrag.Dragged now) {
    dragged = now;
    live(now.placements());
    view.repaint();
  }

  /** Shows Transforms in other poses in the running scene only. */
  private void live(List<Placement> placements) {
    record Live(SelectedNode node, Placement placement) {}
    List<Live> all = new ArrayList<>();
    for (Placement placed : placements) {
      placed
          .transform()
          .filter(each -> each.attached())
          .ifPresent(each -> all.add(new Live(anchors.node(each), placed)));
    }
    if (!all.isEmpty()) {
      thread.tell(
          stage ->
              stage
                  .scene()
                  .ifPresent(
                      scene ->
                          all.forEach(
                              each ->
                                  scene.pose(
                                      each.node().anchors().get(0), each.placement().pose()))));
    }
  }

  @Override
  public void mouseReleased(MouseEvent event) {
    if (takenBack) {
      takenBack = false;
      event.consume();
      return;
    }
    ObjectHandleDrag of = drag;
    if (of == null) {
      return;
    }
    event.consume();
    ObjectHandleDrag.Dragged done = dragged;
    drag = null;
    dragged = null;
    if (!moved) {
      clicked.accept(event);
    } else if (done != null) {
      List<ObjectBox> after = of.objects().boxes(done.placements());
      if (commands.place(done.placements(), of.verb())) {
        expect(after);
      } else { // No edit follows that would reset the shown poses.
        live(of.objects().items().stream().map(PlacementDrag.Item::placement).toList());
      }
    }
    view.repaint();
  }

  private void expect(List<ObjectBox> after) {
    var selected = session.selectedElements();
    expected = List.of();
    if (selected.size() == after.size()) {
      List<ObjectBox> now = new ArrayList<>();
      for (int i = 0; i < after.size(); i++) {
        ObjectBox box = after.get(i);
        now.add(new ObjectBox(selected.get(i), box.own(), box.place(), box.bounds()));
      }
      expected = now;
    }
    expectedRevision = session.document().revision();
  }

  private void cancel() {
    ObjectHandleDrag of = drag;
    if (of != null) {
      live(of.objects().items().stream().map(PlacementDrag.Item::placement).toList());
      drag = null;
      dragged = null;
      takenBack = true;
      view.repaint();
    }
  }
}
