package org.selectiverenderer.enricher.form;

import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.Supplier;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JTextField;
import org.jspecify.annotations.Nullable;

/**
 * Binds a control to a value in the document. What is typed is written on Enter and on focus loss;
 * an invalid text stays in the control, marked, with the reason under it. A change of the document
 * shows in the control, unless that value did not change while the author types.
 */
final class FieldBinding {
  /**
   * The value in the document: reads it as a text, and writes another text or returns why that is
   * invalid.
   */
  record Source(Supplier<String> read, Function<String, Optional<String>> write) {}

  private final JComponent marked;
  private final JLabel complaint;
  private final Supplier<String> typed;
  private final Consumer<String> show;
  private final Source source;

  /** The accessible description of the control while its text is valid. */
  private final @Nullable String described;

  private @Nullable String shown;
  private boolean busy;
  private boolean closed;

  private FieldBinding(
      JComponent marked,
      JLabel complaint,
      Supplier<String> typed,
      Consumer<String> show,
      Source source) {
    this.marked = marked;
    this.complaint = complaint;
    this.typed = typed;
    this.show = show;
    this.source = source;
    this.described = marked.getAccessibleContext().getAccessibleDescription();
    complaint.setVisible(false);
    follow();
  }

  /** Binds a text field. */
  static FieldBinding of(JTextField text, JLabel complaint, Source source) {
    FieldBinding field = new FieldBinding(text, complaint, text::getText, text::setText, source);
    text.addActionListener(event -> field.commit());
    text.addFocusListener(field.leaving());
    return field;
  }

  /** Binds a combo box, editable or not. */
  static FieldBinding of(JComboBox<String> box, JLabel complaint, Source source) {
    FieldBinding field =
        new FieldBinding(
            box,
            complaint,
            () -> {
              Object item = box.isEditable() ? box.getEditor().getItem() : box.getSelectedItem();
              return String.valueOf(item);
            },
            text -> {
              box.setSelectedItem(text);
              box.getEditor().setItem(text);
            },
            source);
    box.addActionListener(event -> field.commit());
    box.getEditor().getEditorComponent().addFocusListener(field.leaving());
    return field;
  }

  private FocusAdapter leaving() {
    return new FocusAdapter() {
      @Override
      public void focusLost(FocusEvent event) {
        if (!event.isTemporary()) {
          commit();
        }
      }
    };
  }

  /** Writes what has been typed. */
  void commit() {
    String text = typed.get();
    if (closed || busy || text.equals(shown)) {
      if (!closed && !busy) {
        mark(Optional.empty());
      }
      return;
    }
    Optional<String> wrong;
    busy = true;
    try {
      wrong = source.write().apply(text);
    } finally {
      busy = false;
    }
    if (wrong.isEmpty()) {
      shown = null; // Shows the value as the document spells it.
      follow();
    }
    mark(wrong);
  }

  /** Updates the control from the document. */
  void follow() {
    String now = source.read().get();
    if (busy || now.equals(shown)) {
      return;
    }
    shown = now;
    busy = true;
    try {
      show.accept(now);
    } finally {
      busy = false;
    }
    mark(Optional.empty());
  }

  /** Ends the binding; later input is ignored. */
  void close() {
    closed = true;
  }

  /** Marks the control with what is wrong with the value in the document. */
  void complain(String why) {
    if (typed.get().equals(shown)) {
      mark(Optional.of(why));
    }
  }

  private void mark(Optional<String> wrong) {
    marked.putClientProperty("JComponent.outline", wrong.isPresent() ? "error" : null);
    marked.getAccessibleContext().setAccessibleDescription(wrong.orElse(described));
    complaint.setText(wrong.orElse(""));
    complaint.setVisible(wrong.isPresent());
  }
}
