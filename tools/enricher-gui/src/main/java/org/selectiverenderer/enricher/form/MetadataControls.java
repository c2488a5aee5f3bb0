package org.selectiverenderer.enricher.form;

import java.awt.FontMetrics;
import java.util.List;
import java.util.stream.Stream;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JTextField;
import org.selectiverenderer.enricher.help.HelpTopic;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.schema.ConsistencyType;

/** The controls of consistency and schemas: of a version, or of a level of another quality. */
final class MetadataControls {
  /**
   * The names of the controls, which are accessible names too.
   *
   * @param typed of the text in the control of the degree
   */
  record Names(String type, String degree, String typed, String schemas) {}

  private final JComboBox<String> type = new JComboBox<>();
  private final JComboBox<String> degree =
      new JComboBox<>(new String[] {DegreeFormat.none(), "low", "high"});
  private final SchemaListField schemas;
  private final JPanel complaints;
  private final List<FieldBinding> fields;

  /**
   * @param others labels for what is wrong with controls before these, said in the same line
   */
  MetadataControls(
      EnricherSession session, MetadataFormModel editing, Names names, JLabel... others) {
    type.addItem(MetadataFormModel.none());
    for (ConsistencyType each : ConsistencyType.values()) {
      type.addItem(each.spelling());
    }
    name(type, names.type(), HelpTopic.TYPE);
    degree.setEditable(true);
    JTextField typed = (JTextField) degree.getEditor().getEditorComponent();
    typed.setColumns(columns(typed));
    name(degree, names.degree(), HelpTopic.DEGREE);
    name(typed, names.degree(), HelpTopic.DEGREE);
    typed.setName(names.typed());
    schemas = new SchemaListField(() -> session.enrichment().schemas());
    name(schemas, names.schemas(), HelpTopic.SCHEMAS);
    schemas.putClientProperty("JTextField.placeholderText", Texts.of("form.commas"));
    boolean writable = session.document().locked().isEmpty();
    type.setEnabled(writable);
    degree.setEnabled(writable);
    schemas.setEditable(writable);
    JLabel degreeComplaint = LabelFactory.complaint();
    JLabel schemasComplaint = LabelFactory.complaint();
    JLabel typeComplaint = LabelFactory.complaint();
    complaints =
        LabelFactory.room(
            Stream.concat(
                    Stream.of(others), Stream.of(typeComplaint, degreeComplaint, schemasComplaint))
                .toArray(JLabel[]::new));
    fields =
        List.of(
            FieldBinding.of(
                type, typeComplaint, new FieldBinding.Source(editing::type, editing::type)),
            FieldBinding.of(
                degree, degreeComplaint, new FieldBinding.Source(editing::degree, editing::degree)),
            FieldBinding.of(
                schemas,
                schemasComplaint,
                new FieldBinding.Source(editing::schemas, editing::schemas)));
  }

  private static void name(JComponent control, String name, HelpTopic topic) {
    control.setName(name);
    control.getAccessibleContext().setAccessibleName(name);
    topic.explain(control);
  }

  /** Columns of a field for degrees: it fits the longest number, and the word for none. */
  private static int columns(JTextField field) {
    FontMetrics metrics = field.getFontMetrics(field.getFont());
    int word = metrics.stringWidth(DegreeFormat.none());
    return Math.max(4, 1 + (int) Math.ceil((double) word / metrics.charWidth('m')));
  }

  /** Adds the controls with their labels to a panel of four columns. */
  void addTo(JPanel panel) {
    panel.add(LabelFactory.of(Texts.of("terms.type"), type, "consistencyType"));
    panel.add(type, "wmin 0");
    panel.add(LabelFactory.of(Texts.of("terms.degree"), degree, "degreeOfConsistency"));
    panel.add(degree, "wmin pref");
    panel.add(LabelFactory.of(Texts.of("terms.schemas"), schemas, "schemaBelonginess"));
    panel.add(schemas, "spanx 3, wmin 0");
    panel.add(complaints, "skip 1, spanx 3, wmin 0, hmin pref");
  }

  /** The control that a label before all of them names. */
  JComponent first() {
    return type;
  }

  void follow() {
    fields.forEach(FieldBinding::follow);
  }

  void commit() {
    fields.forEach(FieldBinding::commit);
  }

  void close() {
    fields.forEach(FieldBinding::close);
  }
}
