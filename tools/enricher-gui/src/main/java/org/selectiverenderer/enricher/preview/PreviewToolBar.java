package org.selectiverenderer.enricher.preview;

import java.util.List;
import java.util.function.Consumer;
import java.util.function.Supplier;
import javax.swing.AbstractButton;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JToggleButton;
import org.selectiverenderer.base.decimal.DecimalFormatter;
import org.selectiverenderer.enricher.compare.CompareMode;
import org.selectiverenderer.enricher.placement.HandleBar;
import org.selectiverenderer.enricher.placement.HandleSettings;
import org.selectiverenderer.enricher.text.Texts;

/**
 * The tool bar above the picture, whose buttons set how the scene is shown and send commands to the
 * preview's thread. For the event dispatch thread.
 */
final class PreviewToolBar extends WrapToolBar {
  private static final long serialVersionUID = 1L;

  private final transient PreviewThread thread;
  private final JComponent picture;
  private final transient SchemaSimulatorPopup asIf;
  private final JToggleButton walk = new JToggleButton(Texts.of("preview.walk"));
  private final JButton asIfButton = new JButton(Texts.of("preview.asif"));
  private final JToggleButton boxes = new JToggleButton(Texts.of("preview.boxes"), true);
  private final JToggleButton wireframe = new JToggleButton(Texts.of("preview.wireframe"));
  private final JButton compareButton = new JButton(Texts.of("compare.off"));
  private transient CompareMode compare = CompareMode.OFF;
  private transient Runnable onLeave = () -> {};
  private transient Consumer<Boolean> onBoxes = shown -> {};

  /**
   * @param picture the component that gets the focus while the author walks
   * @param schemas of the scene
   */
  PreviewToolBar(PreviewThread thread, JComponent picture, Supplier<List<String>> schemas) {
    super(Texts.of("preview.panel"));
    this.thread = thread;
    this.picture = picture;
    asIf = new SchemaSimulatorPopup(schemas, this::showAsIf);
    add(named(walk, Texts.of("preview.walk.tip")));
    add(named(asIfButton, Texts.of("preview.asif.tip")));
    add(named(boxes, Texts.of("preview.boxes.tip")));
    add(named(wireframe, Texts.of("preview.wireframe.tip")));
    addSeparator();
    add(button(Texts.of("preview.frame"), Texts.of("preview.frame.tip"), this::frameSelected));
    add(button(Texts.of("preview.start"), Texts.of("preview.start.tip"), this::home));
    add(button("\u25c0", Texts.of("preview.before.tip"), () -> viewpoint(-1)));
    add(button("\u25b6", Texts.of("preview.next.tip"), () -> viewpoint(+1)));
    add(named(compareButton, Texts.of("compare.tip")));
    compareButton.addActionListener(event -> compare(compare.next()));
    walk.addActionListener(event -> walk(walk.isSelected()));
    asIfButton.addActionListener(event -> asIf.show(asIfButton));
    boxes.addActionListener(event -> boxes(boxes.isSelected()));
    wireframe.addActionListener(event -> wireframe(wireframe.isSelected()));
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

  /** Adds a button after those that choose what is shown. */
  void addAction(String text, String tip, Runnable does) {
    JButton added = button(text, tip, does);
    added.setName(text);
    add(added, getComponentIndex(wireframe) + 1);
  }

  /** Adds the buttons of the handles of selected objects, and their keys. */
  void addHandles(HandleSettings handles, PreviewKeyBindings keys) {
    int at = getComponentIndex(wireframe) + 1;
    for (JToggleButton button : new HandleBar(handles).buttons()) {
      button.getAccessibleContext().setAccessibleDescription(button.getToolTipText());
      add(button, at++);
    }
    keys.put("M", "handleMove", () -> handles.use(HandleSettings.Mode.MOVE));
    keys.put("T", "handleTurn", () -> handles.use(HandleSettings.Mode.TURN));
    keys.put("S", "handleScale", () -> handles.use(HandleSettings.Mode.SCALE));
    keys.put("D", "measure", () -> handles.measure(!handles.measuring()));
  }

  /** Sets the listener for whether the sensors' boxes are drawn. */
  void onBoxes(Consumer<Boolean> listener) {
    onBoxes = listener;
  }

  /** Begins or ends a live walk. */
  void walk(boolean begin) {
    walk.setSelected(begin);
    thread.tell(stage -> stage.walk(begin));
    picture.requestFocusInWindow();
  }

  /** Whether the Walk button is selected. */
  boolean walks() {
    return walk.isSelected();
  }

  /** Follows a walk that began or ended otherwise than by the button. */
  void walked(boolean walking) {
    if (walk.isSelected() != walking) {
      walk.setSelected(walking);
    }
  }

  void asIf(List<String> schemas) {
    asIf.choose(schemas);
  }

  /** Forgets schemas that the scene no longer has. */
  void followSchemas() {
    asIf.follow();
  }

  private void showAsIf(List<String> schemas) {
    asIfButton.setText(
        switch (schemas.size()) {
          case 0 -> Texts.of("preview.asif");
          case 1 -> Texts.of("preview.asif.one", schemas.get(0));
          default ->
              Texts.of(
                  "preview.asif.some",
                  DecimalFormatter.grouped(schemas.size())); // The picture lists their names.
        });
    thread.tell(stage -> stage.asIf(schemas));
  }

  void compare(CompareMode mode) {
    compare = mode;
    compareButton.setText(
        switch (mode) {
          case OFF -> Texts.of("compare.off");
          case WIPE -> Texts.of("compare.wipe");
          case BESIDE -> Texts.of("compare.beside");
        });
    thread.tell(stage -> stage.compare(mode));
  }

  /** Shows or hides the sensors' boxes. */
  void boxes(boolean show) {
    boxes.setSelected(show);
    onBoxes.accept(show);
    thread.tell(stage -> stage.sensorsShown(show));
  }

  private void wireframe(boolean show) {
    wireframe.setSelected(show);
    thread.tell(stage -> stage.wireframe(show));
  }

  private void leave() {
    onLeave.run();
    walk(false);
  }

  /** Sets what else Escape ends. */
  void onLeave(Runnable also) {
    onLeave = also;
  }

  private void frameSelected() {
    thread.tell(PreviewController::frameSelected);
  }

  private void home() {
    thread.tell(PreviewController::home);
  }

  private void viewpoint(int steps) {
    thread.tell(stage -> stage.viewpoint(steps));
  }

  /** Binds the keys of the buttons. */
  void keys(PreviewKeyBindings keys) {
    keys.put("W", "walk", walk::doClick);
    keys.put("I", "asIf", asIfButton::doClick);
    keys.put("B", "boxes", boxes::doClick);
    keys.put("G", "wireframe", wireframe::doClick);
    keys.put("F", "frame", this::frameSelected);
    keys.put("C", "compare", compareButton::doClick);
    keys.put("HOME", "start", this::home);
    keys.put("PAGE_UP", "before", () -> viewpoint(-1));
    keys.put("PAGE_DOWN", "next", () -> viewpoint(+1));
    keys.put("ESCAPE", "leave", this::leave);
  }
}
