package org.selectiverenderer.enricher.form;

import java.awt.FontMetrics;
import java.util.List;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JTextField;
import net.miginfocom.swing.MigLayout;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.authoring.enrichment.EnrichedSwitch;
import org.selectiverenderer.authoring.enrichment.EnrichedSwitch.ChoiceNode;
import org.selectiverenderer.base.decimal.DecimalFormatter;
import org.selectiverenderer.enricher.help.HelpTopic;
import org.selectiverenderer.enricher.preview.VersionImage;
import org.selectiverenderer.enricher.preview.VersionImageRenderer;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.schema.ConsistencyType;
import org.selectiverenderer.swing.PlainText;

/** The form of one choice of a Switch (a row of thesis Fig 44): the version and its metadata. */
final class ChoiceForm {
  private final EnricherSession session;
  private final VersionImageRenderer pictures;
  private final ChoiceNode choice;
  private final JPanel panel =
      new JPanel(new MigLayout("insets 0, hidemode 3, wrap 4", "[][grow,fill][][fill]"));
  private final VersionThumbnail thumbnail;
  private final JLabel polygons = PlainText.only(new JLabel("\u2026"));
  private final JLabel title;
  private final JLabel url;
  private final List<FieldBinding> fields;
  private @Nullable VersionThumbnailLoader loading;

  ChoiceForm(
      EnricherSession session,
      VersionImageRenderer pictures,
      EnrichedSwitch node,
      ChoiceNode choice,
      JComponent buttons) {
    this.session = session;
    this.pictures = pictures;
    this.choice = choice;
    String number = String.valueOf(choice.index());
    ChoiceFormModel editing = new ChoiceFormModel(session, node.element(), choice.index());
    JComboBox<String> type = new JComboBox<>();
    type.addItem(ChoiceFormModel.none());
    for (ConsistencyType each : ConsistencyType.values()) {
      type.addItem(each.spelling());
    }
    name(type, Texts.of("form.type", number), HelpTopic.TYPE);
    JComboBox<String> degree = new JComboBox<>(new String[] {DegreeFormat.none(), "low", "high"});
    degree.setEditable(true);
    JTextField typed = (JTextField) degree.getEditor().getEditorComponent();
    typed.setColumns(columns(typed));
    name(degree, Texts.of("form.degree", number), HelpTopic.DEGREE);
    name(typed, Texts.of("form.degree", number), HelpTopic.DEGREE);
    typed.setName("Typed degree of choice " + number);
    SchemaListField schemas = new SchemaListField(() -> session.enrichment().schemas());
    name(schemas, Texts.of("form.schemas.of", number), HelpTopic.SCHEMAS);
    schemas.putClientProperty("JTextField.placeholderText", Texts.of("form.commas"));
    title = LabelFactory.of("", type);
    title.putClientProperty("FlatLaf.styleClass", "h4");
    if (choice.index() < 10) {
      title.setDisplayedMnemonic('0' + choice.index());
    }
    thumbnail = new VersionThumbnail(Texts.of("form.picture", number));
    url = new JLabel(PlainText.of(shortly(choice)));
    url.setToolTipText(PlainText.of(where(choice)));
    url.getAccessibleContext().setAccessibleName(Texts.of("form.model", number, where(choice)));
    polygons.setName("Polygons of choice " + number);
    polygons.getAccessibleContext().setAccessibleName(Texts.of("form.polygons", number));
    boolean writable = session.document().locked().isEmpty();
    type.setEnabled(writable);
    degree.setEnabled(writable);
    schemas.setEditable(writable);

    JLabel degreeComplaint = LabelFactory.complaint();
    JLabel schemasComplaint = LabelFactory.complaint();
    JLabel typeComplaint = LabelFactory.complaint();
    panel.add(title, "split 2, span, growx, pushx, wmin 0");
    panel.add(buttons, "growx 0");
    JPanel facts = new JPanel(new MigLayout("insets 0, wrap 1, gapy 2", "[grow,fill]"));
    facts.add(url, "wmin 0");
    facts.add(polygons, "wmin 0");
    panel.add(thumbnail, "split 2, span, growx 0");
    panel.add(facts, "growx, wmin 0");
    panel.add(LabelFactory.of(Texts.of("terms.type"), type, "consistencyType"));
    panel.add(type, "wmin 0");
    panel.add(LabelFactory.of(Texts.of("terms.degree"), degree, "degreeOfConsistency"));
    panel.add(degree, "wmin pref");
    panel.add(LabelFactory.of(Texts.of("terms.schemas"), schemas, "schemaBelonginess"));
    panel.add(schemas, "spanx 3, wmin 0");
    JPanel complaints = LabelFactory.room(typeComplaint, degreeComplaint, schemasComplaint);
    panel.add(complaints, "skip 1, spanx 3, wmin 0, hmin pref");
    panel.getAccessibleContext().setAccessibleName(Texts.of("form.choice", number));
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
    follow(node);
  }

  private static void name(JComponent control, String name, HelpTopic topic) {
    control.setName(name);
    control.getAccessibleContext().setAccessibleName(name);
    topic.explain(control);
  }

  private static String where(ChoiceNode choice) {
    return choice.url().isEmpty()
        ? Texts.of("form.inscene", choice.element().toString())
        : choice.url();
  }

  /** The file name without its folders, which would push it out of view. */
  private static String shortly(ChoiceNode choice) {
    String where = where(choice);
    return choice.url().isEmpty() ? where : where.substring(where.lastIndexOf('/') + 1);
  }

  JComponent component() {
    return panel;
  }

  /** Requests the thumbnail, once the screen and thus its resolution are known. */
  void load() {
    if (loading == null) {
      loading =
          new VersionThumbnailLoader(
              session, pictures, thumbnail.pixels(), this::taken, this::failed);
      loading.begin(choice);
    }
  }

  private void taken(VersionImage picture) {
    thumbnail.show(picture.image());
    String text =
        Texts.of(
            "counts.polygons", picture.polygons(), DecimalFormatter.grouped(picture.polygons()));
    polygons.setText(text);
    polygons.getAccessibleContext().setAccessibleName(text);
  }

  private void failed(String sentence) {
    polygons.setText(sentence);
    polygons.setToolTipText(PlainText.of(sentence));
    polygons.getAccessibleContext().setAccessibleName(sentence);
  }

  /** Whether this is the form of a choice. */
  boolean fits(ChoiceNode other) {
    return choice.element() == other.element() && choice.url().equals(other.url());
  }

  void follow(EnrichedSwitch node) {
    title.setText(
        Texts.of(
            node.whichChoice() == choice.index() ? "form.choice.start" : "form.choice",
            String.valueOf(choice.index())));
    fields.forEach(FieldBinding::follow);
  }

  /** Columns of a field for degrees: it fits the longest number, and the word for none. */
  private static int columns(JTextField field) {
    FontMetrics metrics = field.getFontMetrics(field.getFont());
    int word = metrics.stringWidth(DegreeFormat.none());
    return Math.max(4, 1 + (int) Math.ceil((double) word / metrics.charWidth('m')));
  }

  void commit() {
    fields.forEach(FieldBinding::commit);
  }

  void dispose() {
    fields.forEach(FieldBinding::close);
    if (loading != null) {
      loading.cancel();
    }
  }
}
