package org.selectiverenderer.enricher.form;

import java.awt.Component;
import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import javax.swing.JButton;
import javax.swing.JCheckBox;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JTextField;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.authoring.editing.FieldEdits;
import org.selectiverenderer.authoring.editing.InterfaceField;
import org.selectiverenderer.authoring.editing.NodeField;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.swing.PlainText;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * A row with a field of a node: its name, the control that edits it, and a button that resets it to
 * its default.
 */
final class FieldRow {
  private final EnricherSession session;
  private final DocumentElement element;
  private final Supplier<List<DocumentElement>> targets;
  private final FieldEdits edits;
  private final JLabel label;
  private final JLabel complaint = LabelFactory.complaint();
  private final JButton reset = new JButton("\u00d7");
  private final JComponent control;
  private final @Nullable FieldBinding typed;
  private @Nullable JCheckBox check;
  private @Nullable ColorSwatch swatch;
  private @Nullable NodeLinks links;
  private NodeField field;
  private boolean busy;

  /**
   * @param targets the elements that get the value, the element first
   */
  FieldRow(
      EnricherSession session,
      DocumentElement element,
      NodeField field,
      Supplier<List<DocumentElement>> targets) {
    this.session = session;
    this.targets = targets;
    this.element = element;
    this.field = field;
    this.edits = new FieldEdits(session.document());
    boolean free = session.document().locked().isEmpty() && field.readOnly().isEmpty();
    FieldBinding.Source source = new FieldBinding.Source(this::read, this::write);
    switch (field.kind()) {
      case BOOLEAN -> {
        JCheckBox box = new JCheckBox();
        box.addActionListener(event -> choose(Boolean.toString(box.isSelected())));
        box.setEnabled(free);
        check = box;
        control = box;
        typed = null;
      }
      case CHOICE -> {
        JComboBox<String> box = new JComboBox<>(field.choices().toArray(String[]::new));
        box.setEditable(true);
        box.setEnabled(free);
        typed = FieldBinding.of(box, complaint, source);
        control = box;
      }
      case NODES -> {
        NodeLinks held = new NodeLinks(session);
        links = held;
        control = held;
        typed = null;
      }
      default -> {
        JTextField text = new JTextField();
        text.setEditable(free);
        typed = FieldBinding.of(text, complaint, source);
        control = text;
        if (field.kind() == NodeField.Kind.COLOR) {
          ColorSwatch colour = new ColorSwatch(field.name(), this::shown, this::choose);
          colour.setEnabled(free);
          text.putClientProperty("JTextField.trailingComponent", colour);
          swatch = colour;
        } else if (field.name().equals(FieldsForm.URL) && field.ofPrototype().isEmpty()) {
          UrlChooser file = new UrlChooser(session, field.name(), this::choose);
          file.setEnabled(free);
          text.putClientProperty("JTextField.trailingComponent", file);
        }
      }
    }
    String spoken =
        field
            .ofPrototype()
            .map(of -> Texts.of("fields.ofPrototype", field.name(), of.prototype()))
            .orElse(field.name());
    control.setName(key(field));
    control.getAccessibleContext().setAccessibleName(spoken);
    label = LabelFactory.of(field.name(), control);
    reset.setName("reset " + (field.ofPrototype().isPresent() ? key(field) : field.name()));
    reset.setToolTipText(Texts.of("fields.reset", field.name()));
    reset.getAccessibleContext().setAccessibleName(Texts.of("fields.reset", spoken));
    reset.putClientProperty("JButton.buttonType", "borderless");
    reset.addActionListener(event -> unset());
    follow(field);
  }

  /** Returns what tells a field from others of its node: an attribute may have the same name. */
  static String key(NodeField field) {
    return (field.ofPrototype().isPresent() ? "fieldValue " : "field ") + field.name();
  }

  String key() {
    return key(field);
  }

  NodeField field() {
    return field;
  }

  void addTo(JPanel rows) {
    rows.add(label, "wmax 50%");
    rows.add(control, "wmin 0");
    rows.add(reset, "w 26!, hidemode 2, wrap");
    rows.add(complaint, "skip 1, span 2, wmin 0, wrap");
    Component typing =
        control instanceof JComboBox<?> box ? box.getEditor().getEditorComponent() : control;
    typing.addFocusListener(
        new FocusAdapter() {
          @Override
          public void focusGained(FocusEvent event) {
            rows.scrollRectToVisible(control.getBounds()); // a text field does not
          }
        });
  }

  private String read() {
    return field.written().orElse("");
  }

  private String shown() {
    return field.written().orElse(field.defaultText());
  }

  /** Writes a value to the document; an empty text resets the field to its default. */
  private Optional<String> write(String text) {
    if (busy || text.equals(read())) {
      return Optional.empty();
    }
    boolean emptied = text.isBlank() && !key().equals("field USE");
    if (emptied) {
      unset();
      return Optional.empty();
    }
    Optional<String> wrong = edits.wrong(targets.get(), field, text);
    if (wrong.isEmpty()) {
      session.attempt(() -> session.document().perform(edits.set(targets.get(), field, text)));
    }
    return wrong;
  }

  /** Writes what was chosen; what is refused is told, since such a control keeps no text. */
  private Optional<String> choose(String text) {
    Optional<String> wrong = write(text);
    wrong.ifPresent(
        why -> {
          session.message(why);
          follow(field);
        });
    return wrong;
  }

  private void unset() {
    Optional<String> wrong = edits.wrongReset(targets.get(), field);
    if (wrong.isPresent()) {
      session.message(wrong.get());
    } else {
      session.attempt(() -> session.document().perform(edits.unset(targets.get(), field)));
    }
  }

  /** Tells type, default and range, what the author of a prototype says, and why it is locked. */
  private void describe() {
    Optional<InterfaceField> own = field.ofPrototype();
    String elsewhere = Texts.of("fields.elsewhere");
    boolean external = own.filter(InterfaceField::external).isPresent();
    String about = field.about() + (external ? ", " + elsewhere : "");
    String info = own.map(InterfaceField::info).filter(text -> !text.isEmpty()).orElse("");
    String described = about.isEmpty() || info.isEmpty() ? about + info : about + " \u2013 " + info;
    String why =
        field.kind() == NodeField.Kind.NODES ? described : field.readOnly().orElse(described);
    control.setToolTipText(why.isEmpty() ? null : PlainText.of(why));
    label.setToolTipText(control.getToolTipText());
    String initial = external ? elsewhere : field.defaultText();
    if (control instanceof JTextField text) {
      text.putClientProperty("JTextField.placeholderText", initial);
    }
    NodeLinks held = links;
    if (held != null) {
      held.show(
          own.map(InterfaceField::nodes).orElse(List.of()),
          external && field.written().isEmpty() ? elsewhere : Texts.of("fields.noNodes"));
    }
  }

  /** Shows the present value in the document, and marks it if it is invalid. */
  void follow(NodeField now) {
    field = now;
    boolean free = session.document().locked().isEmpty() && field.readOnly().isEmpty();
    reset.setVisible(free && field.written().isPresent());
    describe();
    busy = true;
    try {
      JCheckBox box = check;
      if (box != null) {
        box.setSelected(field.written().orElse(field.defaultText()).strip().equals("true"));
      }
      FieldBinding text = typed;
      if (text != null) {
        text.follow();
        field
            .written()
            .filter(value -> field.readOnly().isEmpty())
            .flatMap(value -> edits.wrong(element, field, value))
            .ifPresent(text::complain);
      }
      ColorSwatch colour = swatch;
      if (colour != null) {
        colour.repaint();
      }
    } finally {
      busy = false;
    }
  }

  void commit() {
    if (typed != null) {
      typed.commit();
    }
  }

  void close() {
    if (typed != null) {
      typed.close();
    }
  }
}
