package org.selectiverenderer.enricher.form;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JSeparator;
import net.miginfocom.swing.MigLayout;
import org.selectiverenderer.authoring.enrichment.EnrichedField;
import org.selectiverenderer.authoring.enrichment.EnrichedSwitch;
import org.selectiverenderer.authoring.enrichment.QualityEdits;
import org.selectiverenderer.authoring.enrichment.QualityTargets;
import org.selectiverenderer.authoring.enrichment.VersionDegreeMapping;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.text.Mnemonics;
import org.selectiverenderer.enricher.text.Remarks;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.enricher.versions.QualityLevelsMaker;
import org.selectiverenderer.schema.FieldLevel;
import org.selectiverenderer.schema.FieldQuality;
import org.selectiverenderer.schema.FieldReference;
import org.selectiverenderer.schema.Quality;
import org.selectiverenderer.schema.VersionMetadata;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * The part of a Switch's form with its qualities: what its versions differ in, and the fields that
 * schemas set besides. A quality that is added or removed does not rebuild the rest of the form.
 */
final class QualitiesForm {
  private static final int LEVELS = 2;

  private final EnricherSession session;
  private final DocumentElement element;
  private final JComboBox<String> versions = new JComboBox<>();
  private final TargetField target;
  private final JButton add = Mnemonics.on(new JButton(), Texts.of("quality.add"));
  private final JLabel complaint = LabelFactory.complaint();
  private final List<QualityForm> fields = new ArrayList<>();
  private final JPanel list = new JPanel(new MigLayout("insets 0, wrap 1", "[grow,fill]"));
  private final JPanel panel =
      new JPanel(new MigLayout("insets 0, wrap 2, hidemode 3", "[][grow,fill]"));
  private final FieldBinding ofVersions;

  QualitiesForm(EnricherSession session, EnrichedSwitch node) {
    this.session = session;
    this.element = node.element();
    this.target = new TargetField(session, element);
    boolean writable = session.document().locked().isEmpty();
    Stream.of(Quality.values()).map(Quality::spelling).forEach(versions::addItem);
    versions.setName("Quality of the versions");
    versions.getAccessibleContext().setAccessibleName(Texts.of("quality.versions"));
    versions.setToolTipText(Texts.of("quality.versions.tip"));
    versions.setEnabled(writable);
    target.setName("Field of a new quality");
    target.getAccessibleContext().setAccessibleName(Texts.of("quality.target"));
    target.setToolTipText(Texts.of("quality.target.tip"));
    target.setEnabled(writable);
    target.addActionListener(event -> add());
    add.setName("Add quality");
    add.setEnabled(writable);
    add.addActionListener(event -> add());
    complaint.putClientProperty("FlatLaf.styleClass", "small");
    complaint.setVisible(false);
    JButton make = new JButton(Texts.of("quality.make"));
    make.setName("Make levels");
    make.setToolTipText(Texts.of("quality.make.tip"));
    make.setEnabled(writable && element.def().isPresent());
    make.addActionListener(
        event -> new QualityLevelsMaker(session).ask(panel, element.def().orElse("")));
    JLabel title = LabelFactory.of(Texts.of("quality.title"), versions);
    title.putClientProperty("FlatLaf.styleClass", "h4");
    JLabel versionsComplaint = LabelFactory.complaint();
    panel.add(new JSeparator(), "span, growx");
    panel.add(title, "span");
    panel.add(LabelFactory.of(Texts.of("quality.versions"), versions), "wmin 0");
    panel.add(versions, "wmin 0");
    panel.add(versionsComplaint, "span, wmin 0");
    panel.add(list, "span, growx, wmin 0");
    panel.add(LabelFactory.of(Texts.of("quality.target"), target), "span, wmin 0, gaptop 8");
    panel.add(target, "split 2, span, growx, pushx, wmin 0");
    panel.add(add, "growx 0");
    panel.add(complaint, "span, wmin 0");
    panel.add(make, "span, growx 0");
    ofVersions =
        FieldBinding.of(
            versions,
            versionsComplaint,
            new FieldBinding.Source(
                () -> node().map(EnrichedSwitch::quality).orElse(Quality.POLYGONS).spelling(),
                this::ofVersions));
    follow(node);
  }

  private Optional<EnrichedSwitch> node() {
    return session.enrichment().switchNode(element);
  }

  private Optional<String> ofVersions(String word) {
    Quality wanted = Quality.of(word).orElse(Quality.POLYGONS);
    if (node().filter(now -> now.enriched()).isEmpty()) {
      return wanted == Quality.POLYGONS
          ? Optional.empty()
          : Optional.of(Texts.of("quality.undescribed"));
    }
    node()
        .ifPresent(
            now ->
                session.attempt(
                    () ->
                        session.perform(
                            new QualityEdits(session.document()).ofVersions(now, wanted))));
    return Optional.empty();
  }

  /** Adds the quality that the author has chosen a field for: levels with its present value. */
  private void add() {
    Optional<FieldReference> wanted = FieldReference.of(target.getText());
    QualityTargets targets = new QualityTargets(session.document(), session.catalogue());
    Optional<String> wrong =
        wanted.isEmpty()
            ? Optional.of(Texts.of("quality.target.form"))
            : targets.wrong(element, wanted.get()).map(Remarks::shown);
    mark(wrong);
    if (wrong.isPresent() || node().isEmpty()) {
      return;
    }
    List<String> present = targets.present(element, wanted.get());
    List<FieldLevel> levels =
        IntStream.range(0, LEVELS)
            .mapToObj(
                i ->
                    new FieldLevel(
                        new VersionMetadata(
                            i,
                            Optional.empty(),
                            Optional.of(VersionDegreeMapping.degree(i, LEVELS)),
                            List.of()),
                        present))
            .toList();
    FieldQuality quality =
        new FieldQuality(targets.proposed(element, wanted.get()), wanted.get(), levels);
    int before = fields.size();
    session.attempt(
        () -> session.perform(new QualityEdits(session.document()).add(node().get(), quality)));
    if (fields.size() > before) {
      target.setText("");
    }
  }

  private void mark(Optional<String> wrong) {
    target.putClientProperty("JComponent.outline", wrong.isPresent() ? "error" : null);
    complaint.setText(wrong.orElse(""));
    complaint.setVisible(wrong.isPresent());
  }

  JComponent component() {
    return panel;
  }

  /** Shows the state of the document. */
  void follow(EnrichedSwitch node) {
    ofVersions.follow();
    boolean same = fields.size() == node.fields().size();
    for (int i = 0; same && i < fields.size(); i++) {
      same = fields.get(i).fits(node.fields().get(i));
    }
    if (!same) {
      fields.forEach(QualityForm::close); // their controls lose the focus now
      fields.clear();
      list.removeAll();
      for (EnrichedField field : node.fields()) {
        QualityForm form = new QualityForm(session, node, field, fields.size());
        fields.add(form);
        list.add(form.component(), "wmin 0");
      }
      list.setVisible(!fields.isEmpty());
      panel.revalidate();
      panel.repaint();
    }
    fields.forEach(QualityForm::follow);
  }

  void commit() {
    ofVersions.commit();
    List.copyOf(fields).forEach(QualityForm::commit);
  }

  void close() {
    ofVersions.close();
    fields.forEach(QualityForm::close);
  }
}
