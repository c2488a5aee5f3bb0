package org.selectiverenderer.enricher.versions;

import java.util.Optional;
import javax.swing.DefaultComboBoxModel;
import javax.swing.JComboBox;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JSlider;
import javax.swing.JSpinner;
import javax.swing.SpinnerNumberModel;
import net.miginfocom.swing.MigLayout;
import org.selectiverenderer.authoring.versions.ObjectVersion;
import org.selectiverenderer.base.decimal.DecimalFormatter;
import org.selectiverenderer.enricher.text.Texts;

/** The column of one version: its goal, its figures, and its mesh as a solid and as a wireframe. */
@SuppressWarnings("serial") // never written
final class VersionPanel extends JPanel {
  private static final long serialVersionUID = 1L;

  private final VersionsModel model;
  private final int index;
  private final MeshView solid;
  private final MeshView wires;
  private final JLabel polygons = new JLabel();
  private final JLabel vertices = new JLabel();
  private final JLabel error = new JLabel();
  private final JComboBox<VersionGoal.Kind> kind =
      new JComboBox<>(new VersionGoal.Kind[] {VersionGoal.Kind.PERCENT, VersionGoal.Kind.COUNT});
  private final JSlider slider = new JSlider(1, 100, 50);
  private final JSpinner spinner = new JSpinner(new SpinnerNumberModel(50.0, 0.1, 100.0, 1.0));
  private boolean following;

  /**
   * @param index 0 for the original
   */
  VersionPanel(VersionsModel model, int index, TurntableCamera turntable) {
    super(new MigLayout("insets 0, fill", "[grow,fill]", "[][]rel[grow,fill][grow,fill][]"));
    this.model = model;
    this.index = index;
    this.solid = new MeshView(turntable, false);
    this.wires = new MeshView(turntable, true);
    String name = String.valueOf(index + 1);
    solid.getAccessibleContext().setAccessibleName(Texts.of("versions.picture.solid", name));
    wires.getAccessibleContext().setAccessibleName(Texts.of("versions.picture.wires", name));
    JLabel title =
        new JLabel(Texts.of(index == 0 ? "versions.original" : "versions.version", name));
    title.putClientProperty("FlatLaf.styleClass", "h4");
    add(title, "wrap");
    add(goal(name), "wrap");
    add(solid, "grow, wrap");
    add(wires, "grow, wrap");
    add(figures(name));
  }

  private JPanel goal(String name) {
    JPanel panel = new JPanel(new MigLayout("insets 0, fillx", "[][grow,fill][]"));
    for (javax.swing.JComponent control : new javax.swing.JComponent[] {kind, slider, spinner}) {
      control.setVisible(index > 0); // they keep their space, so that the views are aligned
    }
    kind.getAccessibleContext().setAccessibleName(Texts.of("versions.goal", name));
    slider.getAccessibleContext().setAccessibleName(Texts.of("versions.vertices.of", name));
    spinner.getAccessibleContext().setAccessibleName(Texts.of("versions.vertices.number", name));
    ((JSpinner.DefaultEditor) spinner.getEditor())
        .getTextField()
        .getAccessibleContext()
        .setAccessibleName(Texts.of("versions.vertices.number", name));
    ((JSpinner.DefaultEditor) spinner.getEditor()).getTextField().setColumns(5);
    kind.addActionListener(
        e -> wish(current().as((VersionGoal.Kind) kind.getSelectedItem(), model.maxVertex())));
    slider.addChangeListener(e -> wish(new VersionGoal(current().kind(), slider.getValue())));
    spinner.addChangeListener(
        e -> wish(new VersionGoal(current().kind(), ((Number) spinner.getValue()).doubleValue())));
    panel.add(kind);
    panel.add(slider, "wmin 60");
    panel.add(spinner);
    return panel;
  }

  private JPanel figures(String name) {
    JPanel panel = new JPanel(new MigLayout("insets 0", "[]unrel[]"));
    String[] heads = {
      index == 0 ? "Max Vertex" : Texts.of("versions.vertices"),
      Texts.of("versions.polygons"),
      Texts.of("versions.error")
    };
    JLabel[] values = {vertices, polygons, error};
    for (int i = 0; i < heads.length; i++) {
      JLabel head = new JLabel(heads[i]);
      head.setLabelFor(values[i]);
      values[i]
          .getAccessibleContext()
          .setAccessibleName(Texts.of("versions.figure", heads[i], name));
      panel.add(head);
      panel.add(values[i], "wrap");
    }
    return panel;
  }

  private VersionGoal current() {
    return model.goals().get(index - 1);
  }

  private void wish(VersionGoal goal) {
    if (!following) {
      model.goal(index - 1, goal);
    }
  }

  /** Updates the controls from the model. */
  void refresh() {
    following = true;
    if (index > 0) {
      showGoal(current());
    }
    following = false;
    Optional<ComputedVersions> result = model.result();
    Optional<ObjectVersion> version =
        result.filter(r -> r.versions().size() > index).map(r -> r.versions().get(index));
    BoundingSphere frame =
        result
            .filter(r -> !r.shapes().isEmpty())
            .flatMap(r -> r.shapes().get(0))
            .map(ColoredMesh::frame)
            .orElse(new BoundingSphere(0, 0, 0, 1));
    ColoredMesh shape = version.flatMap(v -> result.orElseThrow().shapes().get(index)).orElse(null);
    solid.show(shape, frame);
    wires.show(shape, frame);
    boolean stale = !model.current() && index > 0 && !current().keeps();
    polygons.setText(text(version.map(v -> DecimalFormatter.grouped(v.polygons())), stale));
    vertices.setText(text(version.map(v -> DecimalFormatter.grouped(v.vertices())), stale));
    error.setText(text(version.map(this::error), stale));
  }

  private String error(ObjectVersion version) {
    if (Double.isNaN(version.error())) {
      return Texts.of("versions.unmeasured");
    }
    String share = Texts.of("versions.share", DecimalFormatter.fixed(100 * version.error(), 2));
    return version.met() ? share : Texts.of("versions.nearest", share);
  }

  private static String text(Optional<String> value, boolean stale) {
    return stale ? "\u2026" : value.orElse("\u2013");
  }

  private void showGoal(VersionGoal goal) {
    boolean percent = goal.kind() != VersionGoal.Kind.COUNT;
    boolean there = model.existing() > index;
    if (there != (kind.getItemCount() == VersionGoal.Kind.values().length)) {
      kind.setModel(
          new DefaultComboBoxModel<>(
              there
                  ? VersionGoal.Kind.values()
                  : new VersionGoal.Kind[] {VersionGoal.Kind.PERCENT, VersionGoal.Kind.COUNT}));
    }
    slider.setEnabled(!goal.keeps());
    spinner.setEnabled(!goal.keeps());
    int most = percent ? 100 : Math.max(VersionGoal.FEWEST, model.maxVertex());
    kind.setEnabled(model.maxVertex() > 0); // a count needs the vertices of the original
    kind.setSelectedItem(goal.kind());
    slider.setMinimum(percent ? 1 : VersionGoal.FEWEST);
    slider.setMaximum(most);
    if (slider.getValue() != Math.round(goal.value())) {
      slider.setValue((int) Math.round(goal.value()));
    }
    SpinnerNumberModel numbers = (SpinnerNumberModel) spinner.getModel();
    numbers.setMinimum(percent ? VersionGoal.LEAST_PERCENT : (double) VersionGoal.FEWEST);
    numbers.setMaximum((double) most);
    if (numbers.getNumber().doubleValue() != goal.value()) {
      numbers.setValue(goal.value());
    }
  }
}
