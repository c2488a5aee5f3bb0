package org.selectiverenderer.enricher.form;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.selectiverenderer.authoring.enrichment.EnrichedField;
import org.selectiverenderer.authoring.enrichment.EnrichedSwitch;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.schema.Quality;
import org.selectiverenderer.swing.PlainText;
import org.selectiverenderer.x3d.source.DocumentElement;

/** The form of one quality that is a field: what it is, the field, and its levels. */
final class QualityForm {
  private final QualityFormModel model;
  private final List<DocumentElement> elements;
  private final JLabel title = PlainText.only(new JLabel());
  private final JPanel panel =
      new JPanel(new MigLayout("insets 0, hidemode 3, wrap 4", "[][grow,fill][][fill]"));
  private final FieldBinding quality;
  private final FieldBinding target;
  private final List<QualityLevelForm> levels = new ArrayList<>();

  /**
   * @param index of the quality among those of the Switch
   */
  QualityForm(EnricherSession session, EnrichedSwitch node, EnrichedField field, int index) {
    this.model = new QualityFormModel(session, node.element(), index);
    this.elements = elements(field);
    boolean writable = session.document().locked().isEmpty();
    String number = String.valueOf(index + 1);
    JComboBox<String> kinds = new JComboBox<>();
    Stream.of(Quality.values()).map(Quality::spelling).forEach(kinds::addItem);
    name(kinds, Texts.of("quality.of", number), Texts.of("quality.tip"));
    kinds.setEnabled(writable);
    TargetField name = new TargetField(session, node.element());
    name(name, Texts.of("quality.target.of", number), Texts.of("quality.target.tip"));
    name.setEditable(writable);
    title.putClientProperty("FlatLaf.styleClass", "h4");
    JButton remove = removing(Texts.of("quality.remove", number), model::remove);
    remove.setEnabled(writable);
    JLabel wrongQuality = LabelFactory.complaint();
    JLabel wrongTarget = LabelFactory.complaint();
    panel.add(title, "split 2, span, growx, pushx, wmin 0");
    panel.add(remove, "growx 0");
    panel.add(LabelFactory.of(Texts.of("quality.name"), kinds));
    panel.add(kinds, "spanx 3, wmin 0");
    panel.add(LabelFactory.of(Texts.of("quality.field"), name));
    panel.add(name, "spanx 3, wmin 0");
    panel.add(LabelFactory.room(wrongTarget, wrongQuality), "skip 1, spanx 3, wmin 0, hmin pref");
    quality =
        FieldBinding.of(
            kinds, wrongQuality, new FieldBinding.Source(model::quality, model::quality));
    target =
        FieldBinding.of(name, wrongTarget, new FieldBinding.Source(model::target, model::target));
    for (int level = 0; level < elements.size(); level++) {
      QualityLevelForm form = new QualityLevelForm(session, model, level, number);
      form.addTo(panel, elements.size() > 1);
      levels.add(form);
    }
    JButton more = new JButton(Texts.of("quality.level.add"));
    more.setName("Add level to quality " + number);
    more.getAccessibleContext().setAccessibleName(Texts.of("quality.level.add.to", number));
    more.setEnabled(writable);
    more.addActionListener(event -> model.addLevel());
    panel.add(more, "skip 1, spanx 3, growx 0");
    panel.getAccessibleContext().setAccessibleName(Texts.of("quality.of", number));
    follow();
  }

  private static List<DocumentElement> elements(EnrichedField field) {
    return field.levels().stream().map(EnrichedField.Level::element).toList();
  }

  static void name(JComponent control, String name, String tip) {
    control.setName(name);
    control.getAccessibleContext().setAccessibleName(name);
    control.setToolTipText(tip);
  }

  /** Creates the small button that removes what its tip names. */
  static JButton removing(String tip, Runnable removal) {
    JButton button = new JButton("\u2715");
    button.putClientProperty("JButton.buttonType", "toolBarButton");
    name(button, tip, tip);
    button.addActionListener(event -> removal.run());
    return button;
  }

  JComponent component() {
    return panel;
  }

  /** Whether this is the form of a quality. */
  boolean fits(EnrichedField field) {
    return elements.equals(elements(field));
  }

  void follow() {
    String field = model.target();
    if (!field.isEmpty()) {
      title.setText(Texts.of("quality.head", model.quality(), field));
    }
    quality.follow();
    target.follow();
    model.wrongTarget().ifPresent(target::complain);
    levels.forEach(QualityLevelForm::follow);
  }

  void commit() {
    quality.commit();
    target.commit();
    levels.forEach(QualityLevelForm::commit);
  }

  void close() {
    quality.close();
    target.close();
    levels.forEach(QualityLevelForm::close);
  }
}
