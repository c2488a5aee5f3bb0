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
 * Keeps a control and the document in agreement. What is typed is written when it is done (Enter,
 * another control); what means nothing stays in the control, marked, with the reason under it. A
 * change of the document shows in the control, except where it does not concern what is being
 * typed.
 */
final class FormField {
  /** The document's side: a text, and what writes another one and says why it cannot. */
  record Source(Supplier<String> read, Function<String, Optional<String>> write) {}

  private final JComponent marked;
  private final JLabel complaint;
  private final Supplier<String> typed;
  private final Consumer<String> show;
  private final Source source;

  /** What is said of the control to those who do not see it; a tooltip may be markup. */
  private final @Nullable String described;

  private @Nullable String shown;
  private boolean busy;
  private boolean closed;

  private FormField(
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

  /** A text. */
  static FormField of(JTextField text, JLabel complaint, Source source) {
    FormField field = new FormField(text, complaint, text::getText, text::setText, source);
    text.addActionListener(event -> field.commit());
    text.addFocusListener(field.leaving());
    return field;
  }

  /** Some words, or what is typed if the box allows that. */
  static FormField of(JComboBox<String> box, JLabel complaint, Source source) {
    FormField field =
        new FormField(
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
      shown = null; // What was not written goes; what was is shown as it is spelled.
      follow();
    }
    mark(wrong);
  }

  /** Shows what the document says. */
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

  /** Nothing that is typed counts any more. */
  void close() {
    closed = true;
  }

  /** Says what is wrong with what the document has. */
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
