package org.selectiverenderer.enricher.preview;

import java.awt.Component;
import java.awt.Point;
import java.awt.event.ActionEvent;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.awt.event.MouseEvent;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import java.util.function.Supplier;
import javax.swing.AbstractAction;
import javax.swing.AbstractButton;
import javax.swing.Action;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JProgressBar;
import javax.swing.JToggleButton;
import javax.swing.JToolBar;
import javax.swing.KeyStroke;
import javax.swing.SwingUtilities;
import net.miginfocom.swing.MigLayout;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.decimal.DecimalText;
import org.selectiverenderer.base.problem.Location;
import org.selectiverenderer.document.SceneDocument;
import org.selectiverenderer.document.area.GridStep;
import org.selectiverenderer.enricher.area.SceneProbe;
import org.selectiverenderer.enricher.compare.CompareMode;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.session.SelectionListener;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.runtime.viewer.Pose;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * The 3D preview of an open document: its unsaved state, a moment after each edit, as our own
 * runtime shows it. A click selects the object in the document; what is selected elsewhere is
 * outlined. The boxes of the sensors are drawn and labelled. The scene is shown as if the viewer
 * were in any set of schemas, or walked in live.
 *
 * <p>For the event dispatch thread; {@link #dispose()} ends its threads.
 */
public final class PreviewPanel extends JPanel {
  private static final long serialVersionUID = 1L;
  private static final double STEP = Math.toRadians(5);
  private static final double SHIFT = 0.05;

  /** Before the name of an action: what it does, in the bundles. */
  private static final String KEYS = "preview.key.";

  private transient BiConsumer<Component, Point> menu = (over, at) -> {};
  private final transient EnricherSession session;
  private final transient PreviewThread thread;
  private final transient SceneFeed feed;
  private final transient AsIfChooser asIf;
  private final transient SelectionListener onSelection = this::selected;
  private final transient AtomicReference<@Nullable PreviewFrame> arrived = new AtomicReference<>();
  private final transient SceneProbe probe;
  private final transient AreaHandles handles;
  private transient Supplier<GridStep> grid = () -> GridStep.NONE;
  private final JToolBar bar = new WrappingBar(Texts.of("preview.panel"));
  private transient Consumer<PreviewFrame> onFrame = frame -> {};
  private final PictureView view = new PictureView();
  private final JLabel message = new JLabel(" ");

  /** What is said where the scene has layers that are not shown. */
  private String layersLeftOut = " ";

  private final JProgressBar progress = new JProgressBar();
  private final JToggleButton walk = new JToggleButton(Texts.of("preview.walk"));
  private final JToggleButton sensors = new JToggleButton(Texts.of("preview.boxes"), true);
  private final JToggleButton wireframe = new JToggleButton(Texts.of("preview.wireframe"));
  private final JButton asIfButton = new JButton(Texts.of("preview.asif"));
  private final JButton compareButton = new JButton(Texts.of("compare.off"));
  private transient CompareMode compare = CompareMode.OFF;
  private boolean disposed;

  public PreviewPanel(EnricherSession session) {
    super(new MigLayout("insets 0, gap 0, wrap 1", "[grow,fill]", "[][grow,fill][]"));
    this.session = session;
    thread =
        new PreviewThread(
            new PreviewThread.Listener() {
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
            });
    asIf = new AsIfChooser(() -> session.enrichment().schemas(), this::showAsIf);
    probe = new PreviewProbe(thread, this::anchors);
    handles =
        new AreaHandles(
            view,
            session,
            () -> grid.get(),
            (area, box) -> {
              List<Anchor> sensor = anchors(area.element());
              float[] centre = area.frame().ownCentre(box);
              float[] size = area.frame().ownSize(box);
              thread.tell(
                  stage -> stage.scene().ifPresent(shown -> shown.box(sensor, centre, size)));
            });
    new PictureHands(
        view,
        thread,
        new PictureHands.Clicks() {
          @Override
          public void label(PreviewFrame.Label label) {
            picked(
                new PreviewStage.Picked(
                    label.anchor(), view.frame().map(PreviewFrame::revision).orElse(-1L)));
          }

          @Override
          public void scene(int pixelX, int pixelY, boolean innermost) {
            thread.tell(
                stage ->
                    stage.pick(
                        pixelX,
                        pixelY,
                        innermost,
                        meant -> SwingUtilities.invokeLater(() -> picked(meant))));
          }

          @Override
          public void menu(MouseEvent event, int pixelX, int pixelY) {
            Consumer<PreviewStage.Picked> meant =
                found -> {
                  picked(found);
                  menu.accept(view, event.getPoint());
                };
            thread.tell(
                stage ->
                    stage.pick(
                        pixelX,
                        pixelY,
                        false,
                        found -> SwingUtilities.invokeLater(() -> meant.accept(found))));
          }
        });
    layOut();
    keys();
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
          if (walk.isSelected() && !isShowing()) {
            walk(false); // Nobody walks in a picture that is not seen.
          }
        });
    session.addSelectionListener(onSelection);
    feed =
        new SceneFeed(
            session.document(),
            () -> session.file().path(),
            session.access(),
            thread,
            new SceneFeed.Listener() {
              @Override
              public void loading() {
                progress.setVisible(true);
                message.setText(Texts.of("preview.loading.now"));
              }

              @Override
              public void loaded() {
                progress.setVisible(false);
                message.setText(" ");
                asIf.follow();
                tellSelection();
              }

              @Override
              public void stale(String sentence) {
                PreviewPanel.this.stale(sentence);
              }
            });
    feed.now();
    tellSelection();
  }

  private void layOut() {
    bar.add(named(walk, Texts.of("preview.walk.tip")));
    bar.add(named(asIfButton, Texts.of("preview.asif.tip")));
    bar.add(named(sensors, Texts.of("preview.boxes.tip")));
    bar.add(named(wireframe, Texts.of("preview.wireframe.tip")));
    bar.addSeparator();
    bar.add(button(Texts.of("preview.frame"), Texts.of("preview.frame.tip"), this::frameSelected));
    bar.add(button(Texts.of("preview.start"), Texts.of("preview.start.tip"), this::home));
    bar.add(button("\u25c0", Texts.of("preview.before.tip"), () -> viewpoint(-1)));
    bar.add(button("\u25b6", Texts.of("preview.next.tip"), () -> viewpoint(+1)));
    bar.add(named(compareButton, Texts.of("compare.tip")));
    compareButton.addActionListener(event -> compare(compare.next()));
    walk.addActionListener(event -> walk(walk.isSelected()));
    asIfButton.addActionListener(event -> asIf.show(asIfButton));
    sensors.addActionListener(event -> sensorsShown(sensors.isSelected()));
    wireframe.addActionListener(event -> wireframe(wireframe.isSelected()));
    progress.setIndeterminate(true);
    progress.setVisible(false);
    progress.getAccessibleContext().setAccessibleName(Texts.of("preview.loading"));
    message.getAccessibleContext().setAccessibleName(Texts.of("preview.state"));
    JPanel foot = new JPanel(new MigLayout("insets 2 6 2 6, hidemode 3", "[grow,fill][]"));
    foot.add(message, "wmin 0");
    foot.add(progress, "wmax 20%");
    add(bar, "wmin 0"); // A long text of a button does not push the picture out of the window.
    add(view, "wmin 0, hmin 0");
    add(foot);
    getAccessibleContext().setAccessibleName(Texts.of("preview.panel"));
  }

  private static <T extends AbstractButton> T named(T button, String tip) {
    button.setToolTipText(tip);
    button.getAccessibleContext().setAccessibleDescription(tip);
    return button;
  }

  private static JButton button(String text, String tip, Runnable does) {
    JButton button = named(new JButton(text), tip);
    button.getAccessibleContext().setAccessibleName(tip);
    button.addActionListener(event -> does.run());
    return button;
  }

  private void keys() {
    key("W", "walk", walk::doClick);
    key("I", "asIf", asIfButton::doClick);
    key("B", "boxes", sensors::doClick);
    key("G", "wireframe", wireframe::doClick);
    key("F", "frame", this::frameSelected);
    key("C", "compare", compareButton::doClick);
    key("V", "nextVersion", () -> version(+1));
    key("shift V", "ownVersion", () -> version(0));
    key("ctrl LEFT", "lineLeft", () -> view.line(view.comparison().line() - SHIFT));
    key("ctrl RIGHT", "lineRight", () -> view.line(view.comparison().line() + SHIFT));
    key("HOME", "start", this::home);
    key("PAGE_UP", "before", () -> viewpoint(-1));
    key("PAGE_DOWN", "next", () -> viewpoint(+1));
    key("LEFT", "turnLeft", () -> turn(STEP, 0));
    key("RIGHT", "turnRight", () -> turn(-STEP, 0));
    key("UP", "turnUp", () -> turn(0, STEP));
    key("DOWN", "turnDown", () -> turn(0, -STEP));
    key("shift LEFT", "shiftLeft", () -> pan(-SHIFT, 0));
    key("shift RIGHT", "shiftRight", () -> pan(SHIFT, 0));
    key("shift UP", "shiftUp", () -> pan(0, SHIFT));
    key("shift DOWN", "shiftDown", () -> pan(0, -SHIFT));
    key("PLUS", "nearer", () -> zoom(1));
    key("EQUALS", "nearer", () -> zoom(1));
    key("ADD", "nearer", () -> zoom(1));
    key("MINUS", "farther", () -> zoom(-1));
    key("SUBTRACT", "farther", () -> zoom(-1));
    key("ESCAPE", "leave", () -> walk(false));
  }

  /** A key of the picture while the author looks; keys of the walk are consumed before. */
  private void key(String stroke, String name, Runnable does) {
    view.getInputMap(JComponent.WHEN_FOCUSED).put(KeyStroke.getKeyStroke(stroke), name);
    Action action = action(does);
    action.putValue(Action.NAME, Texts.of(KEYS + name));
    view.getActionMap().put(name, action);
  }

  private static Action action(Runnable does) {
    return new AbstractAction() {
      private static final long serialVersionUID = 1L;

      @Override
      public void actionPerformed(ActionEvent event) {
        does.run();
      }
    };
  }

  private void showArrived() {
    PreviewFrame frame = arrived.getAndSet(null);
    if (frame != null && !disposed) {
      view.show(frame);
      if (walk.isSelected() != frame.walking()) {
        walk.setSelected(frame.walking());
      }
      tellLayers(frame.otherLayers());
      onFrame.accept(frame);
    }
  }

  /** Says that the picture is not all of the scene, unless something else is said. */
  private void tellLayers(int others) {
    String before = layersLeftOut;
    layersLeftOut =
        others == 0 ? " " : Texts.of("preview.layers", others, DecimalText.grouped(others));
    if (message.getText().equals(before) || message.getText().isBlank()) {
      message.setText(layersLeftOut);
    }
  }

  /** What shows the menu of the selected node: over which component, where. */
  public void onMenu(BiConsumer<Component, Point> shown) {
    menu = shown;
  }

  /** Keeps the last good picture and says why there is no newer one. */
  private void stale(String sentence) {
    progress.setVisible(false);
    message.setText(sentence);
    message.setToolTipText(sentence);
  }

  private void picked(PreviewStage.Picked picked) {
    element(picked).ifPresent(element -> session.select(element, this));
  }

  private Optional<DocumentElement> element(PreviewStage.Picked picked) {
    SceneDocument document = session.document();
    Anchor anchor = picked.anchor();
    return document
        .tree()
        .flatMap(
            tree -> {
              Optional<DocumentElement> named = anchor.def().flatMap(tree::named);
              boolean sameText = document.revision() == picked.revision();
              return named.isPresent() || !sameText
                  ? named
                  : tree.at(document.offset(anchor.line(), anchor.column()));
            });
  }

  private void selected(Optional<DocumentElement> element, Object origin) {
    tellSelection();
  }

  private void tellSelection() {
    List<Anchor> anchors = session.selection().map(this::anchors).orElse(List.of());
    thread.ask(stage -> stage.select(anchors));
  }

  /** Of an element and those around it, the nearest first. */
  private List<Anchor> anchors(DocumentElement of) {
    List<Anchor> anchors = new ArrayList<>();
    Optional<DocumentElement> at = Optional.of(of).filter(DocumentElement::attached);
    while (at.isPresent()) {
      DocumentElement element = at.get();
      Location place = session.document().location(element.start());
      anchors.add(
          new Anchor(
              element.def().isPresent() ? element.def() : element.use(),
              place.line(),
              place.column()));
      at = element.parent();
    }
    return anchors;
  }

  /** Answers what is asked of the running scene. */
  public SceneProbe probe() {
    return probe;
  }

  /** The grid that the handles of areas snap to. */
  public void grid(Supplier<GridStep> setting) {
    grid = setting;
  }

  /** Adds a button behind those that choose what is shown. */
  public void addAction(String text, String tip, Runnable does) {
    JButton added = button(text, tip, does);
    added.setName(text);
    bar.add(added, bar.getComponentIndex(wireframe) + 1);
  }

  /** Shows the scene as if the viewer were in these schemas, later ones overruling earlier ones. */
  public void asIf(List<String> schemas) {
    asIf.choose(schemas);
  }

  private void showAsIf(List<String> schemas) {
    asIfButton.setText(
        switch (schemas.size()) {
          case 0 -> Texts.of("preview.asif");
          case 1 -> Texts.of("preview.asif.one", schemas.get(0));
          default ->
              Texts.of(
                  "preview.asif.some",
                  DecimalText.grouped(schemas.size())); // The picture names them.
        });
    thread.tell(stage -> stage.asIf(schemas));
  }

  /** Shows the scene with all polygons beside or under the picture, or not. */
  public void compare(CompareMode mode) {
    compare = mode;
    compareButton.setText(
        switch (mode) {
          case OFF -> Texts.of("compare.off");
          case WIPE -> Texts.of("compare.wipe");
          case BESIDE -> Texts.of("compare.beside");
        });
    thread.tell(stage -> stage.compare(mode));
  }

  /**
   * Shows another version of the selected object in its place.
   *
   * @param steps counted from the present one; 0 for the one that the schemas say
   */
  public void version(int steps) {
    thread.tell(stage -> stage.version(steps));
  }

  /** Begins or ends a live walk. */
  public void walk(boolean begin) {
    walk.setSelected(begin);
    thread.tell(stage -> stage.walk(begin));
    view.requestFocusInWindow();
  }

  /** Draws the sensors' boxes or not. */
  public void sensorsShown(boolean show) {
    sensors.setSelected(show);
    handles.shown(show);
    thread.tell(stage -> stage.sensorsShown(show));
  }

  /** Draws edges of polygons only or not. */
  public void wireframe(boolean show) {
    wireframe.setSelected(show);
    thread.tell(stage -> stage.wireframe(show));
  }

  /** Brings the selected object into view, or the whole scene if none is selected. */
  public void frameSelected() {
    thread.tell(PreviewStage::frameSelected);
  }

  /** To the start viewpoint. */
  public void home() {
    thread.tell(PreviewStage::home);
  }

  /** To another viewpoint, counted from the present one. */
  public void viewpoint(int steps) {
    thread.tell(stage -> stage.viewpoint(steps));
  }

  private void turn(double yaw, double pitch) {
    thread.tell(stage -> stage.orbit().turn(yaw, pitch));
  }

  private void pan(double right, double up) {
    thread.tell(stage -> stage.orbit().pan(right, up));
  }

  private void zoom(double notches) {
    thread.tell(stage -> stage.orbit().zoom(notches));
  }

  /** What draws the picture; empty while there is none. */
  public Optional<String> drawnBy() {
    return view.frame().map(PreviewFrame::drawnBy);
  }

  /** Loads the document anew, for instance because a file that it names has been written. */
  public void reload() {
    feed.now();
  }

  /** Where the picture drawn last was seen from; empty before the first. */
  public Optional<Pose> pose() {
    return thread.pose();
  }

  /** The component that shows the picture. */
  PictureView view() {
    return view;
  }

  /** What is said under the picture. */
  String message() {
    return message.getText();
  }

  /** Hears every frame that is shown. */
  void onFrame(Consumer<PreviewFrame> listener) {
    onFrame = listener;
  }

  /** Ends its threads. */
  public void dispose() {
    disposed = true;
    session.removeSelectionListener(onSelection);
    feed.close();
    thread.close();
  }
}
