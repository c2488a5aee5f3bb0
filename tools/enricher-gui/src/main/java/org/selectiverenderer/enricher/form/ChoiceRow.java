package org.selectiverenderer.enricher.form;

import java.awt.Font;
import java.awt.Image;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Supplier;
import javax.swing.ImageIcon;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.SwingConstants;
import javax.swing.UIManager;
import net.miginfocom.swing.MigLayout;
import org.selectiverenderer.document.enrichment.ChoiceValues;
import org.selectiverenderer.document.enrichment.SwitchNode.ChoiceNode;
import org.selectiverenderer.enricher.help.HelpTexts;
import org.selectiverenderer.schema.ConsistencyType;
import org.selectiverenderer.schema.Degree;

/** What is said of one version of an object. */
final class ChoiceRow {
  private static final String NOTHING = "not said";

  private final JPanel panel =
      new JPanel(new MigLayout("insets 10, gap 6, fillx, hidemode 3", "[][grow]", "[]2[]2[]8[]"));
  private final JLabel picture = new JLabel("", SwingConstants.CENTER);
  private final JLabel title = new JLabel();
  private final JLabel figures = new JLabel(" ");
  private final JLabel file = new JLabel();
  private final JComboBox<String> type = new JComboBox<>();
  private final JComboBox<String> degree = new JComboBox<>();
  private final SchemaField schemas;
  private final Consumer<ChoiceValues> changed;
  private ChoiceValues values = ChoiceValues.NONE;
  private boolean showing;

  /**
   * @param changed hears what the author wants
   */
  ChoiceRow(
      int index, Supplier<List<String>> known, boolean editable, Consumer<ChoiceValues> changed) {
    this.changed = changed;
    String of = " of choice " + index;
    schemas =
        new SchemaField(
            "Schemas" + of, HelpTexts.SCHEMAS, known, wanted -> tell(values.with(wanted)));
    type.addItem(NOTHING);
    for (ConsistencyType each : ConsistencyType.values()) {
      type.addItem(each.spelling());
    }
    degree.addItem(NOTHING);
    degree.addItem(Degree.LOW.spelling());
    degree.addItem(Degree.HIGH.spelling());
    degree.setEditable(true);
    name(type, "Type" + of, HelpTexts.TYPE);
    name(degree, "Degree" + of, HelpTexts.DEGREE);
    name((JComponent) degree.getEditor().getEditorComponent(), "Degree" + of, HelpTexts.DEGREE);
    picture.getAccessibleContext().setAccessibleName("Picture" + of);
    title.setFont(title.getFont().deriveFont(Font.BOLD));
    title.getAccessibleContext().setAccessibleName("Version" + of);
    figures.getAccessibleContext().setAccessibleName("Polygons" + of);
    figures.setForeground(UIManager.getColor("Label.disabledForeground"));
    file.getAccessibleContext().setAccessibleName("File" + of);
    file.setForeground(UIManager.getColor("Label.disabledForeground"));
    type.setEnabled(editable);
    degree.setEnabled(editable);
    schemas.component().setEnabled(editable);
    type.addActionListener(event -> typeChosen());
    degree.addActionListener(event -> degreeChosen());
    panel.putClientProperty("FlatLaf.style", "arc: 10; background: lighten($Panel.background,3%)");
    picture.setPreferredSize(null);
    panel.add(picture, "span 1 3, w 104!, h 78!");
    panel.add(title, "growx, wmin 0, wrap, aligny bottom");
    panel.add(figures, "growx, wmin 0, wrap");
    panel.add(file, "growx, wmin 0, wrap, aligny top");
    field("Type", type);
    field("Degree", degree);
    field("Schemas", schemas.component());
  }

  private void field(String text, JComponent field) {
    JLabel label = new JLabel(text);
    label.setLabelFor(field);
    panel.add(label, "alignx right");
    panel.add(field, "growx, wmin 80, wrap");
  }

  private static void name(JComponent control, String name, String help) {
    control.getAccessibleContext().setAccessibleName(name);
    control.setToolTipText("<html><body width=260>" + help);
  }

  JPanel component() {
    return panel;
  }

  void show(ChoiceNode choice, boolean shownAtStart) {
    showing = true;
    try {
      values = choice.values();
      String url = choice.url().isEmpty() ? choice.element().name() : choice.url();
      title.setText("Version " + choice.index() + (shownAtStart ? " (at the start)" : ""));
      title.setToolTipText(url);
      file.setText(file(url));
      file.setToolTipText(url);
      type.setSelectedItem(values.type().map(ConsistencyType::spelling).orElse(NOTHING));
      degree.setSelectedItem(values.degree().map(Degree::spelling).orElse(NOTHING));
      degree.putClientProperty("JComponent.outline", null);
      schemas.show(values.schemas());
    } finally {
      showing = false;
    }
  }

  private static String file(String url) {
    return url.substring(url.lastIndexOf('/') + 1);
  }

  /** Shows how the version looks. */
  void show(VersionImages.Look look) {
    Image scaled = look.image();
    picture.setIcon(new ImageIcon(scaled));
    figures.setText("%,d polygons".formatted(look.polygons()));
  }

  /** Shows why there is no picture. */
  void showLack(String sentence) {
    picture.setText("no picture");
    picture.setEnabled(false);
    picture.setToolTipText(sentence);
  }

  private void typeChosen() {
    if (!showing) {
      Optional<ConsistencyType> wanted = ConsistencyType.of(String.valueOf(type.getSelectedItem()));
      tell(new ChoiceValues(wanted, values.degree(), values.schemas()));
    }
  }

  private void degreeChosen() {
    if (showing) {
      return;
    }
    String word = String.valueOf(degree.getSelectedItem()).strip();
    Optional<Degree> wanted = Degree.of(word);
    boolean wrong = wanted.isEmpty() && !word.isEmpty() && !word.equals(NOTHING);
    degree.putClientProperty("JComponent.outline", wrong ? "error" : null);
    if (!wrong) {
      tell(new ChoiceValues(values.type(), wanted, values.schemas()));
    }
  }

  private void tell(ChoiceValues wanted) {
    if (!showing && !wanted.equals(values)) {
      changed.accept(wanted);
    }
  }

  void commit() {
    schemas.commit();
  }
}
