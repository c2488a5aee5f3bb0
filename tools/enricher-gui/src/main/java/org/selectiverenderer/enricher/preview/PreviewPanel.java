package org.selectiverenderer.enricher.preview;

import java.awt.Component;
import java.awt.Point;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import java.util.function.Supplier;
import javax.swing.JPanel;
import javax.swing.SwingUtilities;
import net.miginfocom.swing.MigLayout;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.authoring.area.AreaBox;
import org.selectiverenderer.authoring.area.AreaInstance;
import org.selectiverenderer.authoring.area.SnapGrid;
import org.selectiverenderer.browser.viewer.Pose;
import org.selectiverenderer.enricher.area.AsyncSceneQueries;
import org.selectiverenderer.enricher.compare.CompareMode;
import org.selectiverenderer.enricher.placement.HandleSettings;
import org.selectiverenderer.enricher.placement.SelectionPath;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.session.SelectionListener;
import org.selectiverenderer.enricher.text.Texts;

/**
 * The 3D preview of an open document, which shows its unsaved state shortly after each edit with
 * our own runtime. A click selects the object in the document; what is selected elsewhere is
 * outlined. The boxes of the sensors are drawn and labelled. The scene can be shown as if the
 * viewer were in any set of schemas, or walked in live.
 *
 * <p>For the event dispatch thread; {@link #dispose()} ends its threads.
 */
public final class PreviewPanel extends JPanel {
  private static final long serialVersionUID = 1L;

  private final transient EnricherSession session;
  private final transient SourceAnchorResolver anchors;
  private final transient PreviewThread thread;
  private final transient PreviewUpdater feed;
  private final transient SelectionListener onSelection = (element, origin) -> tellSelection();
  private final transient AtomicReference<@Nullable PreviewFrame> arrived = new AtomicReference<>();
  private final transient AsyncSceneQueries probe;
  private final transient PickHandler clicks;
  private final transient ObjectHandles objects;
  private final transient MeasureOverlay measure;
  private final transient PreviewKeyBindings keys;
  private final SelectionPath path;
  private final PreviewCanvas view = new PreviewCanvas();
  private final PreviewStatusBar foot = new PreviewStatusBar();
  private final PreviewToolBar bar;
  private final AnimationBar animation;
  private transient Supplier<SnapGrid> grid = () -> SnapGrid.NONE;
  private transient Consumer<PreviewFrame> onFrame = frame -> {};
  private boolean disposed;

  public PreviewPanel(EnricherSession session) {
    super(
        new MigLayout("insets 0, gap 0, wrap 1, hidemode 3", "[grow,fill]", "[][][grow,fill][][]"));
    this.session = session;
    anchors = new SourceAnchorResolver(session.document());
    thread = new PreviewThread(new Pictures());
    probe = new PreviewSceneQueries(thread, anchors);
    animation = new AnimationBar(thread);
    bar = new PreviewToolBar(thread, view, () -> session.enrichment().schemas());
    AreaHandles handles = new AreaHandles(view, session, () -> grid.get(), this::showBox);
    bar.onBoxes(handles::shown);
    clicks = new PickHandler(view, thread, session, this);
    PreviewInputController[] mouse = new PreviewInputController[1];
    objects =
        new ObjectHandles(
            view, session, thread, anchors, probe, () -> grid.get(), e -> mouse[0].click(e));
    mouse[0] = new PreviewInputController(view, thread, clicks);
    measure = new MeasureOverlay(view, thread);
    clicks.measuring(measure);
    bar.onLeave(measure::end);
    path = new SelectionPath(session);
    add(bar, "wmin 0"); // a long button text must not push the picture out
    add(path, "wmin 0");
    add(view, "wmin 0, hmin 0");
    add(animation, "wmin 0");
    add(foot);
    getAccessibleContext().setAccessibleName(Texts.of("preview.panel"));
    keys = new PreviewKeyBindings(view);
    keys.look(view, thread);
    bar.keys(keys);
    view.addComponentListener(
        new ComponentAdapter() {
          @Override
          public void componentResized(ComponentEvent event) {
            int width = view.toPixels(view.getWidth());
            int height = view.toPixels(view.getHeight());
            thread.tell(stage -> stage.size(width, height));
          }
        });
    addHierarchyListener(
        event -> {
          if (bar.walks() && !isShowing()) {
            walk(false); // A hidden preview does not walk on.
          }
        });
    session.addSelectionListener(onSelection);
    feed =
        new PreviewUpdater(
            session.document(),
            () -> session.file().path(),
            session::access,
            thread,
            new Loading());
    feed.now();
    tellSelection();
  }

  /**
   * Receives frames on the preview's thread; the event dispatch thread shows the newest of them.
   */
  private final class Pictures implements PreviewThread.Listener {
    @Override
    public void drawn(PreviewFrame frame) {
      if (arrived.getAndSet(frame) == null) {
        SwingUtilities.invokeLater(PreviewPanel.this::showArrived);
      }
    }

    @Override
    public void failed(String sentence) {
      SwingUtilities.invokeLater(() -> stale(sentence));
    }
  }

  private final class Loading implements PreviewUpdater.Listener {
    @Override
    public void loading() {
      foot.loading();
      view.waiting().loading();
    }

    @Override
    public void loaded() {
      foot.loaded();
      view.waiting().drawing();
      bar.followSchemas();
      tellSelection();
    }

    @Override
    public void stale(String sentence) {
      PreviewPanel.this.stale(sentence);
    }
  }

  private void stale(String sentence) {
    foot.stale(sentence);
    view.waiting().none(foot.message());
  }

  private void showArrived() {
    PreviewFrame frame = arrived.getAndSet(null);
    if (frame != null && !disposed) {
      view.show(frame);
      bar.walked(frame.walking());
      animation.follow(thread.animation(), frame.walking());
      foot.layersLeftOut(frame.otherLayers());
      onFrame.accept(frame);
    }
  }

  /** Shows an area's box in the running scene while a handle is dragged. */
  private void showBox(AreaInstance area, AreaBox box) {
    List<SourceAnchor> sensor = anchors.of(area.element());
    float[] centre = area.frame().ownCentre(box);
    float[] size = area.frame().ownSize(box);
    thread.tell(stage -> stage.scene().ifPresent(shown -> shown.box(sensor, centre, size)));
  }

  private void tellSelection() {
    List<SelectedNode> selected = anchors.nodes(session.selectedElements());
    thread.ask(stage -> stage.select(selected));
  }

  /** Sets what shows the context menu of the selected node, over a component at a point. */
  public void onMenu(BiConsumer<Component, Point> shown) {
    clicks.onMenu(shown);
  }

  /** The queries of the running scene. */
  public AsyncSceneQueries probe() {
    return probe;
  }

  /** Answers what is under a point of a component, in scene coordinates; empty where nothing is. */
  public void place(Component over, Point at, Consumer<Optional<Vector3d>> answer) {
    Point inside = SwingUtilities.convertPoint(over, at, view);
    new PlacementQueries(thread).under(view.toPixels(inside.x), view.toPixels(inside.y), answer);
  }

  /** Answers a place on the floor before the viewer; empty while there is no picture. */
  public void placeAhead(Consumer<Optional<Vector3d>> answer) {
    new PlacementQueries(thread).ahead(answer);
  }

  /** Answers the floor or surface below a point; the point itself where there is none. */
  public void onFloor(Vector3dc point, Consumer<Vector3d> answer) {
    new PlacementQueries(thread)
        .below(point, found -> answer.accept(found.orElseGet(() -> new Vector3d(point))));
  }

  /** Sets the grid that the handles of areas snap to. */
  public void grid(Supplier<SnapGrid> setting) {
    grid = setting;
  }

  /** Sets what the handles of selected objects do, with buttons and keys that choose it. */
  public void handles(HandleSettings settings) {
    objects.settings(settings);
    measure.settings(settings);
    bar.addHandles(settings, keys);
  }

  /** Adds a button after those that choose what is shown. */
  public void addAction(String text, String tip, Runnable does) {
    bar.addAction(text, tip, does);
  }

  /** Shows the scene as if the viewer were in these schemas, later ones overruling earlier ones. */
  public void asIf(List<String> schemas) {
    bar.asIf(schemas);
  }

  /** Shows the scene in full detail beside or under the picture, or not. */
  public void compare(CompareMode mode) {
    bar.compare(mode);
  }

  /**
   * Shows another version of the selected object in its place.
   *
   * @param steps number of versions to go on from the present one; 0 for the one that the schemas
   *     select
   */
  public void version(int steps) {
    thread.tell(stage -> stage.version(steps));
  }

  /** Begins or ends a live walk. */
  public void walk(boolean begin) {
    bar.walk(begin);
  }

  /** Shows or hides the sensors' boxes. */
  public void sensorsShown(boolean show) {
    bar.boxes(show);
  }

  /** The OpenGL renderer of the picture; empty while there is none. */
  public Optional<String> drawnBy() {
    return view.frame().map(PreviewFrame::drawnBy);
  }

  /** Loads the document again, for instance because a file that it names has been written. */
  public void reload() {
    feed.now();
  }

  /** The viewer's pose in the last picture; empty before the first. */
  public Optional<Pose> pose() {
    return thread.pose();
  }

  /** The component that shows the picture. */
  PreviewCanvas view() {
    return view;
  }

  /** The words about what is measured. */
  String measured() {
    return measure.words();
  }

  /** The text of the status line. */
  String message() {
    return foot.message();
  }

  /** Sets a listener for every frame that is shown. */
  void onFrame(Consumer<PreviewFrame> listener) {
    onFrame = listener;
  }

  /** Ends its threads. */
  public void dispose() {
    disposed = true;
    session.removeSelectionListener(onSelection);
    path.dispose();
    feed.close();
    thread.close();
  }
}
