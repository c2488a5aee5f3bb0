package org.selectiverenderer.enricher.form;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Stream;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JTextField;
import net.miginfocom.swing.MigLayout;
import org.selectiverenderer.authoring.Edit;
import org.selectiverenderer.authoring.enrichment.EnrichedField;
import org.selectiverenderer.authoring.enrichment.EnrichedSwitch;
import org.selectiverenderer.authoring.enrichment.QualityEdits;
import org.selectiverenderer.authoring.enrichment.QualityTargets;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.text.Remarks;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.schema.FieldReference;
import org.selectiverenderer.schema.Quality;
import org.selectiverenderer.swing.PlainText;
import org.selectiverenderer.x3d.source.DocumentElement;

/** The form of one quality that is a field: what it is, the field, and its levels. */
final class QualityForm {
  private final EnricherSession session;
  private final DocumentElement element;
  private final int index;
  private final List<DocumentElement> levels;
  private final JLabel title = PlainText.only(new JLabel());
  private final JPanel panel =
      new JPanel(new MigLayout("insets 0, hidemode 3, wrap 4", "[][grow,fill][][fill]"));
  private final List<FieldBinding> bindings = new ArrayList<>();
  private final List<MetadataControls> metadata = new ArrayList<>();

  /** What is wrong with the document's value of each binding that can have something wrong. */
  private final List<Runnable> complaints = new ArrayList<>();

  /**
   * @param index of the quality among those of the Switch
   */
  QualityForm(EnricherSession session, EnrichedSwitch node, EnrichedField field, int index) {
    this.session = session;
    this.element = node.element();
    this.index = index;
    this.levels = field.levels().stream().map(EnrichedField.Level::element).toList();
    boolean writable = session.document().locked().isEmpty();
    String number = String.valueOf(index + 1);
    JComboBox<String> quality = new JComboBox<>();
    Stream.of(Quality.values()).map(Quality::spelling).forEach(quality::addItem);
    name(quality, Texts.of("quality.of", number), Texts.of("quality.tip"));
    quality.setEnabled(writable);
    TargetField target = new TargetField(session, element);
    name(target, Texts.of("quality.target.of", number), Texts.of("quality.target.tip"));
    target.setEditable(writable);
    title.putClientProperty("FlatLaf.styleClass", "h4");
    panel.add(title, "split 2, span, growx, pushx, wmin 0");
    panel.add(
        small("\u2715", "quality.remove", number, now -> edits().remove(now.node(), now.field())),
        "growx 0");
    JLabel qualityComplaint = LabelFactory.complaint();
    JLabel targetComplaint = LabelFactory.complaint();
    panel.add(LabelFactory.of(Texts.of("quality.name"), quality, "quality"));
    panel.add(quality, "spanx 3, wmin 0");
    panel.add(LabelFactory.of(Texts.of("quality.field"), target, "field"));
    panel.add(target, "spanx 3, wmin 0");
    panel.add(
        LabelFactory.room(targetComplaint, qualityComplaint), "skip 1, spanx 3, wmin 0, hmin pref");
    bindings.add(
        FieldBinding.of(
            quality,
            qualityComplaint,
            new FieldBinding.Source(
                () -> now().map(now -> now.field().quality().spelling()).orElse(""),
                this::quality)));
    FieldBinding ofTarget =
        FieldBinding.of(
            target,
            targetComplaint,
            new FieldBinding.Source(
                () -> now().map(now -> now.field().target().toString()).orElse(""), this::target));
    bindings.add(ofTarget);
    complaints.add(
        () ->
            now()
                .flatMap(now -> targets().wrong(element, now.field().target()))
                .map(Remarks::shown)
                .ifPresent(ofTarget::complain));
    for (int i = 0; i < levels.size(); i++) {
      addLevel(i, number, writable);
    }
    JButton more = new JButton(Texts.of("quality.level.add"));
    more.setName("Add level to quality " + number);
    more.getAccessibleContext().setAccessibleName(Texts.of("quality.level.add.to", number));
    more.setEnabled(writable);
    more.addActionListener(event -> edit(now -> edits().addLevel(now.field())));
    panel.add(more, "skip 1, spanx 3, growx 0");
    panel.getAccessibleContext().setAccessibleName(Texts.of("quality.of", number));
    follow();
  }

  /** What the form shows, as it is in the document now. */
  private record Now(EnrichedSwitch node, EnrichedField field) {}

  private Optional<Now> now() {
    return session
        .enrichment()
        .switchNode(element)
        .filter(node -> index < node.fields().size())
        .map(node -> new Now(node, node.fields().get(index)));
  }

  private QualityEdits edits() {
    return new QualityEdits(session.document());
  }

  private QualityTargets targets() {
    return new QualityTargets(session.document(), session.catalogue());
  }

  private void addLevel(int level, String number, boolean writable) {
    String spoken = Texts.of("quality.level.of", String.valueOf(level), number);
    JTextField value = new JTextField();
    name(value, Texts.of("quality.value.of", spoken), Texts.of("quality.value.tip"));
    value.setEditable(writable);
    JLabel complaint = LabelFactory.complaint();
    JLabel head = LabelFactory.of(Texts.of("quality.level", String.valueOf(level)), value);
    panel.add(head, "split 2, span, growx, pushx, wmin 0, gaptop 4");
    JButton remove =
        small(
            "\u2715",
            "quality.level.remove",
            spoken,
            now -> edits().removeLevel(now.field(), level));
    remove.setEnabled(writable && levels.size() > 1);
    panel.add(remove, "growx 0");
    panel.add(LabelFactory.of(Texts.of("quality.value"), value, "value"));
    panel.add(value, "spanx 3, wmin 0");
    panel.add(LabelFactory.room(complaint), "skip 1, spanx 3, wmin 0, hmin pref");
    FieldBinding ofValue =
        FieldBinding.of(
            value,
            complaint,
            new FieldBinding.Source(
                () -> level(level).map(of -> shown(of.values())).orElse(""),
                text -> value(level, text)));
    bindings.add(ofValue);
    complaints.add(
        () ->
            now()
                .filter(now -> level < now.field().levels().size())
                .flatMap(
                    now ->
                        targets()
                            .wrong(
                                element,
                                now.field().target(),
                                now.field().levels().get(level).values()))
                .map(Remarks::shown)
                .ifPresent(ofValue::complain));
    MetadataControls controls =
        new MetadataControls(
            session,
            new MetadataFormModel(
                session,
                () -> level(level).map(EnrichedField.Level::metadata),
                wanted -> {
                  Now now = now().orElseThrow();
                  return edits().metadata(now.node(), now.field(), level, wanted);
                }),
            new MetadataControls.Names(
                Texts.of("quality.type.of", spoken),
                Texts.of("quality.degree.of", spoken),
                "Typed degree of " + spoken,
                Texts.of("quality.schemas.of", spoken)));
    metadata.add(controls);
    controls.addTo(panel);
  }

  private Optional<EnrichedField.Level> level(int level) {
    return now()
        .filter(now -> level < now.field().levels().size())
        .map(now -> now.field().levels().get(level));
  }

  private String shown(List<String> values) {
    return now().map(now -> targets().shown(element, now.field().target(), values)).orElse("");
  }

  private static void name(JComponent control, String name, String tip) {
    control.setName(name);
    control.getAccessibleContext().setAccessibleName(name);
    control.setToolTipText(tip);
  }

  private JButton small(String sign, String key, String argument, Function<Now, Edit> making) {
    String tip = Texts.of(key, argument);
    JButton button = new JButton(sign);
    button.putClientProperty("JButton.buttonType", "toolBarButton");
    button.setToolTipText(tip);
    button.getAccessibleContext().setAccessibleName(tip);
    button.setName(tip);
    button.setEnabled(session.document().locked().isEmpty());
    button.addActionListener(event -> edit(making));
    return button;
  }

  private Optional<String> quality(String word) {
    edit(now -> edits().quality(now.field(), Quality.of(word).orElseThrow()));
    return Optional.empty();
  }

  private Optional<String> target(String text) {
    Optional<FieldReference> wanted = FieldReference.of(text);
    if (wanted.isEmpty()) {
      return Optional.of(Texts.of("quality.target.form"));
    }
    Optional<String> wrong = targets().wrong(element, wanted.get()).map(Remarks::shown);
    if (wrong.isEmpty()) {
      edit(now -> edits().target(now.node(), now.field(), wanted.get()));
    }
    return wrong;
  }

  private Optional<String> value(int level, String text) {
    if (now().isEmpty()) {
      return Optional.empty();
    }
    FieldReference target = now().get().field().target();
    List<String> values = targets().values(element, target, text);
    Optional<String> wrong = targets().wrong(element, target, values).map(Remarks::shown);
    if (wrong.isEmpty()) {
      edit(now -> edits().value(now.field(), level, values));
    }
    return wrong;
  }

  private void edit(Function<Now, Edit> making) {
    now().ifPresent(now -> session.attempt(() -> session.perform(making.apply(now))));
  }

  JComponent component() {
    return panel;
  }

  /** Whether this is the form of a quality. */
  boolean fits(EnrichedField field) {
    return levels.equals(field.levels().stream().map(EnrichedField.Level::element).toList());
  }

  void follow() {
    now()
        .ifPresent(
            now ->
                title.setText(
                    Texts.of(
                        "quality.head",
                        now.field().quality().spelling(),
                        now.field().target().toString())));
    bindings.forEach(FieldBinding::follow);
    metadata.forEach(MetadataControls::follow);
    complaints.forEach(Runnable::run);
  }

  void commit() {
    bindings.forEach(FieldBinding::commit);
    metadata.forEach(MetadataControls::commit);
  }

  void close() {
    bindings.forEach(FieldBinding::close);
    metadata.forEach(MetadataControls::close);
  }
}
