package org.selectiverenderer.enricher.form;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import javax.swing.JCheckBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JSeparator;
import net.miginfocom.swing.MigLayout;
import org.selectiverenderer.authoring.editing.FieldEdits;
import org.selectiverenderer.authoring.editing.InterfaceField;
import org.selectiverenderer.authoring.editing.NodeField;
import org.selectiverenderer.authoring.editing.NodeFieldList;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.swing.PlainText;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * The form of the fields of any node: those that are written in the source, and on request all that
 * its type has, with types, defaults and ranges of the node catalogue; then those that the
 * prototype of an instance declares. Each change is one edit of one attribute or fieldValue.
 */
final class FieldsForm implements Form {
  /** Most fields of a prototype that are shown while the form is to show written ones only. */
  private static final int MANY = 60;

  /** The field without which a node that has it shows nothing: it is always in the form. */
  static final String URL = "url";

  private final EnricherSession session;
  private final DocumentElement element;
  private final JPanel rows =
      new JPanel(new MigLayout("insets 0, gapy 3, hidemode 3", "[][grow,fill][]"));
  private final JCheckBox all = new JCheckBox(Texts.of("fields.all"));
  private final JCheckBox others = new JCheckBox();
  private final JPanel panel =
      new JPanel(new MigLayout("insets 8 0 0 0, wrap 1, hidemode 3", "[grow,fill]"));
  private final Choice choice;
  private List<FieldRow> shown = List.of();
  private List<String> names = List.of();

  /** Whether all fields are shown; shared by the forms of successive nodes. */
  static final class Choice {
    private boolean all;
  }

  FieldsForm(EnricherSession session, DocumentElement element, Choice choice) {
    this.session = session;
    this.element = element;
    this.choice = choice;
    JLabel title = new JLabel(Texts.of("fields.title"));
    title.putClientProperty("FlatLaf.styleClass", "h4");
    all.setName("allFields");
    all.setSelected(choice.all);
    all.addActionListener(
        event -> {
          choice.all = all.isSelected();
          build();
        });
    JPanel head = new JPanel(new MigLayout("insets 0", "[grow][]"));
    head.add(title);
    head.add(all);
    panel.add(new JSeparator());
    panel.add(head);
    others.setName("otherNodes");
    panel.add(others, "wmin 0");
    panel.add(rows, "wmin 0");
    build();
  }

  /** Returns the elements that get what is typed: the element, and others if the author says so. */
  private List<DocumentElement> targets() {
    return others.isSelected() && others.isVisible() ? alike() : List.of(element);
  }

  private List<DocumentElement> alike() {
    return new FieldEdits(session.document()).alike(element, session.selectedElements());
  }

  /** Offers to set fields of the other selected nodes, too, if there are some of this type. */
  private void offerOthers() {
    int more = alike().size() - 1;
    others.setVisible(more > 0);
    others.setText(Texts.of("fields.others", more, Integer.toString(more)));
  }

  private List<NodeField> wanted() {
    List<NodeField> fields = NodeFieldList.of(session.document(), session.catalogue(), element);
    Set<String> offered = new HashSet<>();
    fields.stream()
        .filter(field -> field.ofPrototype().isPresent())
        .limit(choice.all ? Long.MAX_VALUE : MANY)
        .forEach(field -> offered.add(FieldRow.key(field)));
    return fields.stream()
        .filter(
            field ->
                choice.all
                    || field.written().isPresent()
                    || field.name().equals(URL) && element.use().isEmpty()
                    || offered.contains(FieldRow.key(field)))
        .toList();
  }

  /** Returns what decides which rows there are, and with which controls. */
  private static List<String> names(List<NodeField> fields) {
    return fields.stream()
        .map(field -> FieldRow.key(field) + " " + field.kind() + " " + prototype(field))
        .sorted()
        .toList();
  }

  private static String prototype(NodeField field) {
    return field.ofPrototype().map(InterfaceField::prototype).orElse("");
  }

  /** Tells where the rows begin that are fields of a prototype, not attributes. */
  private void head(String prototype) {
    JLabel title = PlainText.only(new JLabel(Texts.of("fields.prototype", prototype)));
    title.setName("fields of prototype");
    title.putClientProperty("FlatLaf.styleClass", "h4");
    rows.add(title, "span, wmin 0, gaptop 6, wrap");
  }

  private void build() {
    offerOthers();
    dispose();
    rows.removeAll();
    List<NodeField> fields = wanted();
    names = names(fields);
    List<FieldRow> made = new ArrayList<>();
    boolean headed = false;
    for (NodeField field : fields) {
      if (field.ofPrototype().isPresent() && !headed) {
        head(prototype(field));
        headed = true;
      }
      FieldRow row = new FieldRow(session, element, field, this::targets);
      row.addTo(rows);
      made.add(row);
    }
    if (fields.isEmpty()) {
      rows.add(LabelFactory.sentences(Texts.of("fields.none")), "span, pushx, growx, wmin 0");
    }
    shown = made;
    rows.revalidate();
    rows.repaint();
  }

  @Override
  public JComponent component() {
    return panel;
  }

  @Override
  public boolean fits() {
    return element.attached();
  }

  @Override
  public void follow() {
    offerOthers();
    Map<String, NodeField> now = new HashMap<>();
    List<NodeField> fields = wanted();
    fields.forEach(field -> now.put(FieldRow.key(field), field));
    if (names(fields).equals(names)) {
      shown.forEach(row -> row.follow(now.getOrDefault(row.key(), row.field())));
    } else {
      build();
    }
  }

  @Override
  public void commit() {
    List.copyOf(shown).forEach(FieldRow::commit);
  }

  @Override
  public void dispose() {
    shown.forEach(FieldRow::close);
  }
}
