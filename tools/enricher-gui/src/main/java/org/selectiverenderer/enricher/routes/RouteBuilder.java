package org.selectiverenderer.enricher.routes;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JLabel;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.selectiverenderer.authoring.Edit;
import org.selectiverenderer.authoring.routes.EventField;
import org.selectiverenderer.authoring.routes.RouteEdits;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.text.Mnemonics;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.swing.PlainText;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.ElementScope;

/**
 * The controls that choose the two ends of a new ROUTE. Only fields that send are offered at the
 * start, and at the end only nodes of the same scope with fields that receive the same type.
 */
@SuppressWarnings("serial") // never written
final class RouteBuilder extends JPanel {
  private static final long serialVersionUID = 1L;

  private final EnricherSession session;
  private final JComboBox<Node> fromNode = combo("routes.fromnode");
  private final JComboBox<Field> fromField = combo("routes.fromfield");
  private final JComboBox<Node> toNode = combo("routes.tonode");
  private final JComboBox<Field> toField = combo("routes.tofield");
  private final JButton add = Mnemonics.button("routes.add");
  private boolean filling;

  /** A node of a combo box. */
  private record Node(DocumentElement element) {
    @Override
    public String toString() {
      DocumentElement scope = ElementScope.of(element);
      String name = element.def().orElse("") + "  (" + element.name() + ")";
      return scope.parent().isEmpty()
          ? name
          : name + "  " + Texts.of("routes.in", scope.text("name").orElse(""));
    }
  }

  /** A field of a combo box. */
  private record Field(EventField field) {
    @Override
    public String toString() {
      return field.name() + "  (" + field.type() + ")";
    }
  }

  /**
   * @param adding performs the edit
   */
  RouteBuilder(EnricherSession session, Consumer<Edit> adding) {
    super(new MigLayout("insets 0, fillx", "[][grow,fill,sg][grow,fill,sg][]"));
    this.session = session;
    fromNode.addActionListener(e -> fillFrom());
    fromField.addActionListener(e -> fillTargets());
    toNode.addActionListener(e -> fillTo());
    add.addActionListener(e -> edit().ifPresent(adding));
    add(label("routes.from", fromNode));
    add(fromNode, "wmin 0");
    add(fromField, "wmin 0, wrap");
    add(label("routes.to", toNode));
    add(toNode, "wmin 0");
    add(toField, "wmin 0");
    add(add);
    fill();
  }

  private static <T> JComboBox<T> combo(String text) {
    JComboBox<T> box = PlainText.entries(new JComboBox<>());
    box.getAccessibleContext().setAccessibleName(Texts.of(text));
    box.setMaximumRowCount(20);
    return box;
  }

  private static JLabel label(String text, JComboBox<?> box) {
    JLabel label = Mnemonics.label(text);
    label.setLabelFor(box);
    return label;
  }

  /** Offers the nodes of the present document; keeps what is chosen where it is still there. */
  void fill() {
    List<Node> nodes = new ArrayList<>();
    session
        .document()
        .tree()
        .ifPresent(
            tree ->
                tree.root()
                    .visit(
                        element -> {
                          if (element.def().isPresent() && !fields(element, false).isEmpty()) {
                            nodes.add(new Node(element));
                          }
                        }));
    replace(fromNode, nodes);
    fillFrom();
  }

  private void fillFrom() {
    if (!filling) {
      replace(
          fromField, chosen(fromNode).map(node -> fields(node.element(), false)).orElse(List.of()));
      fillTargets();
    }
  }

  private void fillTargets() {
    if (filling) {
      return;
    }
    List<Node> nodes = new ArrayList<>();
    Optional<Node> source = chosen(fromNode);
    if (source.isPresent() && chosen(fromField).isPresent()) {
      ElementScope.visit(
          source.get().element(),
          element -> {
            if (element.def().isPresent()
                && !element.equals(source.get().element())
                && !fields(element, true).isEmpty()) {
              nodes.add(new Node(element));
            }
          });
    }
    replace(toNode, nodes);
    fillTo();
  }

  private void fillTo() {
    if (!filling) {
      replace(toField, chosen(toNode).map(node -> fields(node.element(), true)).orElse(List.of()));
      add.setEnabled(chosen(toField).isPresent() && session.document().locked().isEmpty());
    }
  }

  /** Returns the fields that send, or those that fit what is chosen at the start. */
  private List<Field> fields(DocumentElement node, boolean input) {
    Optional<EventField> from = chosen(fromField).map(Field::field);
    return EventField.of(node, session.catalogue()).stream()
        .filter(
            field ->
                input
                    ? from.filter(source -> RouteEdits.fit(source, field)).isPresent()
                    : field.sends())
        .filter(field -> !field.name().equals("metadata"))
        .map(Field::new)
        .toList();
  }

  private static <T> Optional<T> chosen(JComboBox<T> box) {
    int index = box.getSelectedIndex();
    return index < 0 ? Optional.empty() : Optional.of(box.getItemAt(index));
  }

  private <T> void replace(JComboBox<T> box, List<T> items) {
    Optional<T> before = chosen(box);
    filling = true;
    try {
      box.removeAllItems();
      items.forEach(box::addItem);
      before.filter(items::contains).ifPresent(box::setSelectedItem);
    } finally {
      filling = false;
    }
    box.setEnabled(!items.isEmpty());
  }

  private Optional<Edit> edit() {
    if (chosen(fromField).isEmpty() || chosen(toField).isEmpty()) {
      return Optional.empty();
    }
    return Optional.of(
        new RouteEdits(session.document())
            .add(
                chosen(fromNode).orElseThrow().element(),
                chosen(fromField).orElseThrow().field(),
                chosen(toNode).orElseThrow().element(),
                chosen(toField).orElseThrow().field()));
  }
}
