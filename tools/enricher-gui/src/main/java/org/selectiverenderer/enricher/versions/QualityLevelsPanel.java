package org.selectiverenderer.enricher.versions;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import javax.swing.JCheckBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JTextField;
import net.miginfocom.swing.MigLayout;
import org.selectiverenderer.authoring.enrichment.EnrichedField;
import org.selectiverenderer.authoring.enrichment.SchemaNameValidator;
import org.selectiverenderer.authoring.qualities.QualityVersionsEdit;
import org.selectiverenderer.enricher.text.Mnemonics;
import org.selectiverenderer.enricher.text.Texts;

/**
 * The fields in which the author says which levels of texture and shading are made: percents, words
 * of shading, and the schemas that select the levels. They begin with the schemas that levels of
 * the object have, as these levels are replaced.
 */
@SuppressWarnings("serial") // never written
final class QualityLevelsPanel extends JPanel {
  private static final long serialVersionUID = 1L;

  private final JTextField percents = new JTextField("50, 25", 14);
  private final JCheckBox vertex =
      Mnemonics.on(new JCheckBox(), Texts.of("versions.levels.vertex"));
  private final JCheckBox flat = Mnemonics.on(new JCheckBox(), Texts.of("versions.levels.flat"));
  private final JTextField schemas = new JTextField(14);

  /**
   * @param there the qualities that the object has
   */
  QualityLevelsPanel(List<EnrichedField> there) {
    super(new MigLayout("insets 0, wrap 2", "[][grow,fill]"));
    add(label("versions.levels.percents", percents, "Percents"));
    add(percents);
    add(new JLabel(Texts.of("versions.levels.shading")));
    JPanel boxes = new JPanel(new MigLayout("insets 0"));
    boxes.add(vertex);
    boxes.add(flat);
    add(boxes);
    schemas.setText(String.join(", ", schemas(there)));
    schemas.setToolTipText(Texts.of("versions.levels.schemas.tip"));
    schemas.putClientProperty(
        "JTextField.placeholderText", Texts.of("versions.levels.schemas.none"));
    add(label("versions.levels.schemas", schemas, "Schemas of the levels"));
    add(schemas);
    add(new JLabel(Texts.of("versions.levels.note")), "span");
  }

  private static JLabel label(String key, JTextField field, String name) {
    JLabel label = Mnemonics.label(key);
    label.setLabelFor(field);
    field.setName(name);
    field.getAccessibleContext().setAccessibleName(label.getText());
    return label;
  }

  /** The schemas of the first quality whose levels have one each; none if there is no such. */
  private static List<String> schemas(List<EnrichedField> there) {
    return there.stream()
        .map(field -> field.levels().stream().map(each -> each.metadata().schemas()).toList())
        .filter(levels -> levels.stream().allMatch(names -> names.size() == 1))
        .findFirst()
        .orElse(List.of())
        .stream()
        .flatMap(List::stream)
        .toList();
  }

  /** The field that gets the focus. */
  JComponent first() {
    return percents;
  }

  /** Returns what is wrong with what the author has entered; empty for nothing. */
  Optional<String> complaint() {
    Optional<List<Double>> sides = percents(percents.getText());
    List<String> words = shading();
    if (sides.isEmpty()) {
      return Optional.of(
          Texts.of("versions.levels.falling", String.valueOf(VersionsModel.MOST)));
    }
    if (sides.get().isEmpty() && words.isEmpty()) {
      return Optional.of(Texts.of("versions.levels.none"));
    }
    List<String> names = names();
    if (names.isEmpty()) {
      return Optional.empty();
    }
    int textures = sides.get().isEmpty() ? 0 : 1 + sides.get().size();
    int shadings = words.isEmpty() ? 0 : 1 + words.size();
    if (textures > 0 && shadings > 0 && textures != shadings) {
      return Optional.of(
          Texts.of(
              "versions.levels.different", String.valueOf(textures), String.valueOf(shadings)));
    }
    int levels = Math.max(textures, shadings);
    return names.size() == levels
        ? names.stream().map(SchemaNameValidator::complaint).flatMap(Optional::stream).findFirst()
        : Optional.of(
            Texts.of(
                "versions.levels.schemas.number",
                String.valueOf(levels),
                String.valueOf(names.size())));
  }

  /** Returns the request for an object, once nothing is wrong. */
  QualityVersionsEdit.Request request(String object) {
    return new QualityVersionsEdit.Request(
        object, percents(percents.getText()).orElseThrow(), shading(), names());
  }

  private List<String> shading() {
    List<String> words = new ArrayList<>();
    if (vertex.isSelected()) {
      words.add("vertex");
    }
    if (flat.isSelected()) {
      words.add("flat");
    }
    return words;
  }

  private List<String> names() {
    return Stream.of(schemas.getText().split(","))
        .map(String::strip)
        .filter(name -> !name.isEmpty())
        .toList();
  }

  /** Returns a few falling numbers between 100 and 0, with commas; empty for anything else. */
  static Optional<List<Double>> percents(String text) {
    List<Double> percents = new ArrayList<>();
    double before = 100;
    for (String word : Stream.of(text.split("[,;\\s%]+")).filter(w -> !w.isEmpty()).toList()) {
      try {
        double percent = Double.parseDouble(word);
        if (!(percent > 0 && percent < before)) {
          return Optional.empty();
        }
        before = percent;
        percents.add(percent);
      } catch (NumberFormatException e) {
        return Optional.empty();
      }
    }
    return percents.size() > VersionsModel.MOST ? Optional.empty() : Optional.of(percents);
  }
}
