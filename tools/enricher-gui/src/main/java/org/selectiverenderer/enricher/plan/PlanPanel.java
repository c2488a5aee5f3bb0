package org.selectiverenderer.enricher.plan;

import java.awt.Component;
import java.awt.Point;
import java.awt.event.ActionEvent;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import javax.swing.AbstractAction;
import javax.swing.JButton;
import javax.swing.JCheckBox;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JFormattedTextField;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JSpinner;
import javax.swing.JToolBar;
import javax.swing.KeyStroke;
import javax.swing.SpinnerNumberModel;
import javax.swing.SwingUtilities;
import javax.swing.Timer;
import net.miginfocom.swing.MigLayout;
import org.joml.Vector3d;
import org.selectiverenderer.authoring.DocumentListener;
import org.selectiverenderer.authoring.area.AreaInstance;
import org.selectiverenderer.authoring.area.AreaLocator;
import org.selectiverenderer.base.decimal.DecimalFormatter;
import org.selectiverenderer.enricher.area.AreaCommands;
import org.selectiverenderer.enricher.area.FloorPlanImage;
import org.selectiverenderer.enricher.area.GridSetting;
import org.selectiverenderer.enricher.area.NamePrompt;
import org.selectiverenderer.enricher.component.WrapLayout;
import org.selectiverenderer.enricher.placement.HandleBar;
import org.selectiverenderer.enricher.placement.HandleSettings;
import org.selectiverenderer.enricher.placement.SelectionPath;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.session.SelectionListener;
import org.selectiverenderer.enricher.text.Texts;

/**
 * The floor plan with its tool bar, in which areas are drawn, moved, resized, named, copied and
 * deleted.
 */
public final class PlanPanel extends JPanel {
  private static final long serialVersionUID = 1L;

  /** Milliseconds after a change, by which the preview has usually loaded it. */
  private static final int PAUSE = 900;

  private final transient EnricherSession session;
  private final transient AreaCommands commands;
  private final transient GridSetting grid;
  private final transient PlanMouseController hands;
  private final transient PlanMenu menu;
  private final transient PlanObjects objects;
  private final SelectionPath path;
  private final transient SelectionListener onSelection = (element, origin) -> selected();
  private final transient DocumentListener onChange = change -> changed();
  private final FloorPlanCanvas view;
  private final JComboBox<String> step = new JComboBox<>();
  private final JSpinner cut = new JSpinner(new SpinnerNumberModel(0.0, null, null, 0.1));
  private final JLabel hint = new JLabel(Texts.of("area.plan.hint"));
  private final Timer later = new Timer(PAUSE, event -> refresh());
  private transient OptionalDouble height = OptionalDouble.empty();
  private transient List<AreaInstance> areas = List.of();
  private transient long read = -1;
  private boolean filling;

  /**
   * @param commands creates and edits areas
   * @param question asks for names
   * @param handles what the handles of objects do
   */
  public PlanPanel(
      EnricherSession session,
      AreaCommands commands,
      NamePrompt question,
      GridSetting grid,
      HandleSettings handles) {
    super(new MigLayout("insets 0, gap 0, wrap 1", "[grow,fill]", "[][][grow,fill][]"));
    this.session = session;
    this.commands = commands;
    this.grid = grid;
    view = new FloorPlanCanvas(this::areas, session::selection);
    objects = new PlanObjects(view, session, commands.probe(), grid, handles);
    menu = new PlanMenu(view, commands, question, objects, this::refresh);
    hands = new PlanMouseController(view, session, commands, grid, menu, objects);
    path = new SelectionPath(session);
    later.setRepeats(false);
    layOut();
    keys();
    session.addSelectionListener(onSelection);
    session.document().addListener(onChange);
    addHierarchyListener(
        event -> {
          if (isShowing()) {
            followGrid();
            refresh();
          }
        });
  }

  private void layOut() {
    JToolBar bar = new JToolBar(Texts.of("area.plan"));
    bar.setFloatable(false);
    WrapLayout.in(bar, 2, 1);
    JButton add = new JButton(Texts.of("area.add.short"));
    add.setName("Add area in plan");
    add.setToolTipText(Texts.of("area.add.tip"));
    add.addActionListener(event -> commands.addAroundSelection());
    bar.add(add);
    bar.addSeparator();
    JLabel cutLabel = new JLabel(Texts.of("area.plan.cut") + " ");
    cutLabel.setLabelFor(cut);
    cut.setName("Cut height");
    cut.setToolTipText(Texts.of("area.plan.cut.tip"));
    cut.setEditor(new JSpinner.NumberEditor(cut, "0.00"));
    JFormattedTextField typed = ((JSpinner.DefaultEditor) cut.getEditor()).getTextField();
    typed.setColumns(6);
    typed.getAccessibleContext().setAccessibleName(Texts.of("area.plan.cut"));
    cut.getAccessibleContext().setAccessibleName(Texts.of("area.plan.cut"));
    for (Component arrow : cut.getComponents()) {
      arrow.getAccessibleContext().setAccessibleName(Texts.of("area.plan.cut"));
    }
    cut.setMaximumSize(cut.getPreferredSize());
    cut.addChangeListener(
        event -> {
          if (!filling) {
            height = OptionalDouble.of(((Number) cut.getValue()).doubleValue());
            refresh();
          }
        });
    bar.add(cutLabel);
    bar.add(cut);
    bar.addSeparator();
    GridSetting.STEPS.forEach(each -> step.addItem(GridSetting.title(each)));
    JLabel stepLabel = new JLabel(Texts.of("area.grid.label") + " ");
    stepLabel.setLabelFor(step);
    step.setName("Grid step");
    step.setMaximumSize(step.getPreferredSize());
    step.addActionListener(
        event -> {
          if (!filling) {
            grid.use(GridSetting.STEPS.get(step.getSelectedIndex()));
            view.grid(grid.step().step());
          }
        });
    bar.add(stepLabel);
    bar.add(step);
    JCheckBox walls = new JCheckBox(Texts.of("area.plan.walls"), grid.walls());
    walls.setName("Snap to walls");
    walls.addActionListener(event -> grid.useWalls(walls.isSelected()));
    bar.add(walls);
    bar.addSeparator();
    JButton fit = new JButton(Texts.of("area.plan.fit"));
    fit.setToolTipText(Texts.of("area.plan.fit.tip"));
    fit.addActionListener(event -> view.fit());
    bar.add(fit);
    JButton fitSelection = new JButton(Texts.of("placement.plan.fitselection"));
    fitSelection.setToolTipText(Texts.of("placement.plan.fitselection.tip"));
    fitSelection.addActionListener(event -> fitSelection());
    bar.add(fitSelection);
    bar.addSeparator();
    new HandleBar(objects.settings()).buttons().forEach(bar::add);
    JPanel foot = new JPanel(new MigLayout("insets 2 6 2 6", "[grow,fill]"));
    hint.setToolTipText(Texts.of("area.plan.hint.tip"));
    foot.add(hint, "wmin 0");
    add(bar, "wmin 0");
    add(path, "wmin 0");
    add(view, "wmin 0, hmin 0");
    add(foot);
    getAccessibleContext().setAccessibleName(Texts.of("area.plan"));
    followGrid();
  }

  /**
   * Returns the place under a point of a component in scene coordinates, at the height of the cut;
   * empty outside of the picture.
   */
  public Optional<Vector3d> place(Component over, Point at) {
    Point inside = SwingUtilities.convertPoint(over, at, view);
    PlanTransform now = view.scale();
    return view.contains(inside) && cut.getValue() instanceof Number y
        ? Optional.of(new Vector3d(now.x(inside.x), y.doubleValue(), now.z(inside.y)))
        : Optional.empty();
  }

  private void keys() {
    key("HOME", view::fit);
    key("F", this::fitSelection);
    key("H", menu::hide);
    key("shift H", menu::showAll);
    key("M", () -> objects.settings().use(HandleSettings.Mode.MOVE));
    key("T", () -> objects.settings().use(HandleSettings.Mode.TURN));
    key("S", () -> objects.settings().use(HandleSettings.Mode.SCALE));
    key("D", () -> objects.settings().measure(!objects.settings().measuring()));
    key("DELETE", menu::delete);
    key("F2", menu::rename);
    key("ctrl C", menu::copy);
    key("ctrl V", menu::paste);
    key("ESCAPE", hands::takeBack);
    key("PAGE_DOWN", () -> next(1));
    key("PAGE_UP", () -> next(-1));
    key("LEFT", () -> nudge(-1, 0));
    key("RIGHT", () -> nudge(1, 0));
    key("UP", () -> nudge(0, -1));
    key("DOWN", () -> nudge(0, 1));
    key("PLUS", () -> zoom(1.25));
    key("EQUALS", () -> zoom(1.25));
    key("MINUS", () -> zoom(0.8));
  }

  private void key(String stroke, Runnable does) {
    view.getInputMap(JComponent.WHEN_FOCUSED).put(KeyStroke.getKeyStroke(stroke), stroke);
    view.getActionMap()
        .put(
            stroke,
            new AbstractAction() {
              private static final long serialVersionUID = 1L;

              @Override
              public void actionPerformed(ActionEvent event) {
                does.run();
              }
            });
  }

  private void zoom(double factor) {
    view.scale(view.scale().zoomed(factor, view.getWidth() / 2.0, view.getHeight() / 2.0));
  }

  /** Selects another area, by steps in document order. */
  private void next(int by) {
    List<AreaInstance> all = areas();
    if (!all.isEmpty()) {
      int now = view.selected().map(all::indexOf).orElse(by > 0 ? -1 : 0);
      session.select(all.get(Math.floorMod(now + by, all.size())).element(), this);
    }
  }

  private void nudge(int x, int z) {
    double by = grid.step().step() > 0 ? grid.step().step() : 0.01;
    if (view.selected().isEmpty()) {
      objects.commands().nudge(new Vector3d(x * by, 0, z * by));
      return;
    }
    view.selected()
        .ifPresent(
            area ->
                commands
                    .nodes()
                    .place(
                        area.element(),
                        area.box().movedBy(new Vector3d(x * by, 0, z * by)),
                        "move"));
  }

  private void followGrid() {
    filling = true;
    step.setSelectedItem(GridSetting.title(grid.step().step()));
    filling = false;
    view.grid(grid.step().step());
  }

  private List<AreaInstance> areas() {
    if (read != session.document().revision()) {
      read = session.document().revision();
      areas = AreaLocator.of(session.enrichment());
    }
    return areas;
  }

  private void selected() {
    repaint();
    objects.follow();
  }

  private void changed() {
    view.repaint();
    if (isShowing()) {
      later.restart();
    }
  }

  /** Requests a new plan image of what the preview has loaded. */
  private void refresh() {
    if (isShowing()) {
      commands
          .probe()
          .plan(
              height, objects.hidden(), found -> found.ifPresentOrElse(this::show, later::restart));
    }
  }

  private void show(FloorPlanImage plan) {
    filling = true;
    cut.setValue(Math.round(plan.cut() * 100) / 100.0);
    filling = false;
    view.show(plan);
    objects.follow();
    say();
  }

  /** Shows how many objects are hidden, or what the mouse does. */
  private void say() {
    int hidden = objects.hidden().size();
    hint.setText(
        hidden == 0
            ? Texts.of("area.plan.hint")
            : Texts.of("placement.plan.hidden", DecimalFormatter.grouped(hidden)));
  }

  private void fitSelection() {
    view.selected()
        .map(FloorPlanCanvas::bounds)
        .or(objects::selectedBounds)
        .ifPresentOrElse(view::fit, view::fit);
  }

  /** The objects of the plan. */
  PlanObjects objects() {
    return objects;
  }

  /** Stops following the session. */
  public void dispose() {
    path.dispose();
    later.stop();
    session.removeSelectionListener(onSelection);
    session.document().removeListener(onChange);
  }
}
