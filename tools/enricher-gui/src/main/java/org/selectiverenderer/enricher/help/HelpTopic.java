package org.selectiverenderer.enricher.help;

import java.awt.Component;
import java.awt.Container;
import java.util.Optional;
import javax.swing.JComponent;
import org.selectiverenderer.enricher.text.Texts;

/** The topics of the help. A control has its topic as a client property. */
public enum HelpTopic {
  SWITCH("switch"),
  SENSOR("sensor"),
  TYPE("type"),
  DEGREE("degree"),
  SCHEMAS("schemas"),
  ENTER("enter"),
  EXIT("exit");

  /** Most characters of a line of a tooltip. */
  private static final int LINE = 50;

  private static final String PROPERTY = "enricher.helpTopic";

  private final String key;

  HelpTopic(String key) {
    this.key = "help." + key;
  }

  public String title() {
    return Texts.of(key);
  }

  /** The explanation, as sentences without the last full stop. */
  public String text() {
    return Texts.of(key + ".text");
  }

  /** Sets this topic for a control: its tooltip, and what the help shows while it has the focus. */
  public void explain(JComponent control) {
    mark(control);
    control.setToolTipText(lines(text())); // Not HTML, whose tags a screen reader would read aloud.
    control.getAccessibleContext().setAccessibleDescription(text());
  }

  /** Breaks a text into lines, as tooltips do not wrap. */
  private static String lines(String sentences) {
    StringBuilder lines = new StringBuilder();
    int length = 0;
    for (String word : sentences.split(" ")) {
      boolean full = length + word.length() > LINE;
      lines.append(length == 0 ? "" : full ? "\n" : " ").append(word);
      length = (full ? 0 : length + 1) + word.length();
    }
    return lines.toString();
  }

  /** Sets this topic for a component and all in it that have no topic of their own. */
  public void mark(JComponent component) {
    component.putClientProperty(PROPERTY, this);
  }

  /** The topic of a component or of the nearest container around it. */
  public static Optional<HelpTopic> of(Component component) {
    for (Container at = component instanceof Container c ? c : component.getParent();
        at != null;
        at = at.getParent()) {
      if (at instanceof JComponent control
          && control.getClientProperty(PROPERTY) instanceof HelpTopic topic) {
        return Optional.of(topic);
      }
    }
    return Optional.empty();
  }
}
