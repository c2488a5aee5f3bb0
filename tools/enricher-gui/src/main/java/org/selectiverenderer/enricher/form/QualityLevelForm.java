package org.selectiverenderer.enricher.form;

import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JTextField;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.text.Texts;

/**
 * The controls of one level of a quality: the value that the field has at this level, and the
 * level's consistency and schemas. Levels count from 1 here, as versions do.
 */
final class QualityLevelForm {
  private final QualityFormModel model;
  private final int level;
  private final JLabel label;
  private final JTextField text = new JTextField();
  private final JButton remove;
  private final JLabel complaint = LabelFactory.complaint();
  private final FieldBinding value;
  private final MetadataControls metadata;
  private final boolean writable;

  /**
   * @param level from 0
   * @param quality number of the quality in the form
   */
  QualityLevelForm(EnricherSession session, QualityFormModel model, int level, String quality) {
    this.model = model;
    this.level = level;
    this.writable = session.document().locked().isEmpty();
    String number = String.valueOf(level + 1);
    String spoken = Texts.of("quality.level.of", number, quality);
    QualityForm.name(text, Texts.of("quality.value.of", spoken), Texts.of("quality.value.tip"));
    text.setEditable(writable);
    label = LabelFactory.of(Texts.of("quality.level", number), text);
    remove =
        QualityForm.removing(
            Texts.of("quality.level.remove", spoken), () -> model.removeLevel(level));
    value =
        FieldBinding.of(
            text,
            complaint,
            new FieldBinding.Source(() -> model.value(level), typed -> model.value(level, typed)));
    metadata =
        new MetadataControls(
            session,
            model.metadata(level),
            new MetadataControls.Names(
                Texts.of("quality.type.of", spoken),
                Texts.of("quality.degree.of", spoken),
                "Typed degree of " + spoken,
                Texts.of("quality.schemas.of", spoken)),
            complaint);
  }

  /** Adds the controls with their labels to a panel of four columns. */
  void addTo(JPanel panel, boolean removable) {
    remove.setEnabled(writable && removable);
    panel.add(label);
    panel.add(text, "split 2, spanx 3, growx, pushx, wmin 0");
    panel.add(remove, "growx 0");
    metadata.addTo(panel);
  }

  void follow() {
    value.follow();
    metadata.follow();
    model.wrongValue(level).ifPresent(value::complain);
  }

  void commit() {
    value.commit();
    metadata.commit();
  }

  void close() {
    value.close();
    metadata.close();
  }
}
