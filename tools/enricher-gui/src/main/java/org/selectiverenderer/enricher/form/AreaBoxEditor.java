package org.selectiverenderer.enricher.form;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.BiFunction;
import java.util.function.ToDoubleFunction;
import java.util.stream.Collectors;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JTextArea;
import javax.swing.JTextField;
import net.miginfocom.swing.MigLayout;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.selectiverenderer.authoring.area.AreaBox;
import org.selectiverenderer.authoring.area.AreaInstance;
import org.selectiverenderer.authoring.area.AreaLocator;
import org.selectiverenderer.base.decimal.DecimalFormatter;
import org.selectiverenderer.enricher.area.NodeCommands;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * Edits the box of an area: centre and size in world coordinates, whatever transforms are around
 * it; and names the areas that it overlaps or belongs together with.
 */
final class AreaBoxEditor {
  private static final String[] AXES = {"X", "Y", "Z"};

  private final EnricherSession session;
  private final NodeCommands nodes;
  private final DocumentElement element;
  private final JPanel panel =
      new JPanel(new MigLayout("insets 0, hidemode 3, wrap 1", "[grow,fill]"));
  private final JPanel numbers =
      new JPanel(
          new MigLayout("insets 0, hidemode 3, wrap 4", "[][grow,fill][grow,fill][grow,fill]"));
  private final List<FieldBinding> fields = new ArrayList<>();
  private final JTextArea frame = LabelFactory.sentences("");
  private final JTextArea relations = LabelFactory.sentences("");

  AreaBoxEditor(EnricherSession session, NodeCommands nodes, DocumentElement element) {
    this.session = session;
    this.nodes = nodes;
    this.element = element;
    if (nodes.area(element).isPresent()) {
      panel.add(numbers, "wmin 0");
      numbers.add(new JLabel());
      for (String axis : AXES) {
        numbers.add(new JLabel(axis), "align center, growx 0");
      }
      row(
          "area.centre",
          "Centre ",
          (box, k) -> box.centre().get(k),
          (box, k) -> value -> new AreaBox(with(box.centre(), k, value), box.size()),
          "move");
      row(
          "area.size",
          "Size ",
          (box, k) -> box.size().get(k),
          (box, k) -> value -> new AreaBox(box.centre(), with(box.size(), k, value)),
          "resize");
    }
    frame.putClientProperty("FlatLaf.styleClass", "small");
    panel.add(frame, "wmin 0");
    panel.add(relations, "wmin 0");
    relations.setName("Other areas");
    follow();
  }

  private interface Changed {
    AreaBox to(double value);
  }

  private static Vector3d with(Vector3dc of, int axis, double value) {
    return new Vector3d(of).setComponent(axis, value);
  }

  private void row(
      String title,
      String name,
      BiFunction<AreaBox, Integer, Double> read,
      BiFunction<AreaBox, Integer, Changed> write,
      String verb) {
    List<JLabel> complaints = new ArrayList<>();
    numbers.add(new JLabel(Texts.of(title)));
    for (int axis = 0; axis < 3; axis++) {
      int k = axis;
      JTextField text = new JTextField(5);
      text.setName(name + AXES[k]);
      String sizes = "area.box.size." + k;
      String spoken = verb.equals("move") ? Texts.of("area.box.centre", AXES[k]) : Texts.of(sizes);
      text.getAccessibleContext().setAccessibleName(spoken);
      text.setToolTipText(spoken + ". " + Texts.of("area.box.metres"));
      text.setEditable(session.document().locked().isEmpty());
      JLabel complaint = LabelFactory.complaint();
      complaints.add(complaint);
      numbers.add(text, "wmin 0");
      fields.add(
          FieldBinding.of(
              text,
              complaint,
              new FieldBinding.Source(
                  () -> shown(box -> read.apply(box, k)),
                  typed -> write(typed, verb, box -> write.apply(box, k)))));
    }
    complaints.forEach(complaint -> numbers.add(complaint, "spanx 4, wmin 0"));
  }

  private String shown(ToDoubleFunction<AreaBox> value) {
    return nodes
        .area(element)
        .map(area -> DecimalFormatter.rounded(value.applyAsDouble(area.box()), 3))
        .orElse("");
  }

  private interface Change {
    Changed of(AreaBox box);
  }

  private Optional<String> write(String typed, String verb, Change change) {
    ParseResult<Double> input = LengthFormat.parse(typed);
    if (input instanceof ParseResult.Wrong<Double> wrong) {
      return Optional.of(wrong.why());
    }
    Optional<AreaInstance> area = nodes.area(element);
    if (area.isEmpty()) {
      return Optional.empty();
    }
    AreaBox box = change.of(area.get().box()).to(((ParseResult.Valid<Double>) input).value());
    if (!box.sound()) {
      return Optional.of(Texts.of("area.box.positive"));
    }
    nodes.place(element, box, verb);
    return Optional.empty();
  }

  List<FieldBinding> fields() {
    return fields;
  }

  JPanel component() {
    return panel;
  }

  /** Shows the present box, its coordinate frame and the related areas. */
  void follow() {
    Optional<AreaInstance> area = nodes.area(element);
    say(frame, area.map(AreaBoxEditor::about).orElseGet(this::unknown));
    say(relations, area.map(this::relations).orElse(""));
  }

  private static void say(JTextArea where, String text) {
    if (!where.getText().equals(text)) {
      where.setText(text);
      where.setVisible(!text.isEmpty());
      where.getAccessibleContext().setAccessibleName(text);
    }
  }

  private String unknown() {
    return Texts.of("area.box.unknown", element.parent().map(String::valueOf).orElse(""));
  }

  private static String about(AreaInstance area) {
    List<String> lines = new ArrayList<>();
    lines.add(Texts.of("area.box.metres"));
    if (!area.frame().transforms().isEmpty()) {
      String around =
          area.frame().transforms().stream().map(String::valueOf).collect(Collectors.joining(", "));
      lines.add(Texts.of(area.frame().turned() ? "area.box.turned" : "area.box.under", around));
    }
    if (!area.elsewhere().isEmpty()) {
      lines.add(Texts.of("area.box.shared", String.join(", ", area.elsewhere())));
    }
    return String.join(". ", lines) + ".";
  }

  private String relations(AreaInstance area) {
    List<AreaInstance> all = AreaLocator.of(session.enrichment());
    List<String> lines = new ArrayList<>();
    AreaLocator.parts(area, all).forEach(part -> lines.add(Texts.of("area.part", part.name())));
    List<AreaLocator.Overlap> overlaps = AreaLocator.overlaps(area, all);
    for (AreaLocator.Overlap overlap : overlaps) {
      String key =
          overlap.within()
              ? "area.overlap.within"
              : overlap.around() ? "area.overlap.around" : "area.overlap.part";
      lines.add(Texts.of(key, overlap.other().name(), DecimalFormatter.fixed(overlap.volume(), 2)));
    }
    if (!overlaps.isEmpty()) {
      lines.add(Texts.of("area.overlap.what"));
    }
    return String.join("\n", lines);
  }

  /** Parses lengths with a decimal point or a decimal comma. */
  private static final class LengthFormat {
    private LengthFormat() {}

    static ParseResult<Double> parse(String text) {
      try {
        double value = Double.parseDouble(text.strip().replace(',', '.'));
        if (Double.isFinite(value)) {
          return new ParseResult.Valid<>(value);
        }
      } catch (NumberFormatException e) {
        // reported below, together with values that are not finite
      }
      return new ParseResult.Wrong<>(
          Texts.of("area.box.number", text.isBlank() ? "\u2423" : text.strip()));
    }
  }
}
