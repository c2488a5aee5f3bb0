package org.selectiverenderer.enricher.help;

import java.awt.Component;
import java.awt.Container;
import java.util.Optional;
import javax.swing.JComponent;
import org.selectiverenderer.enricher.text.Texts;

/** What the help can explain. A control says by a property which topic it is about. */
public enum HelpTopic {
  SWITCH("switch"),
  SENSOR("sensor"),
  TYPE("type"),
  DEGREE("degree"),
  SCHEMAS("schemas"),
  ENTER("enter"),
  EXIT("exit");

  /** Letters of a line of a tooltip. */
  private static final int LINE = 50;

  private static final String PROPERTY = "enricher.helpTopic";

  private final String key;

  HelpTopic(String key) {
    this.key = "help." + key;
  }

  public String title() {
    return Texts.of(key);
  }

  /** What it means, as sentences without the last full stop. */
  public String text() {
    return Texts.of(key + ".text");
  }

  /** Makes a control one about this topic: its tooltip, and what the help shows with it. */
  public void explain(JComponent control) {
    mark(control);
    control.setToolTipText(lines(text())); // Not markup, which would be read aloud.
    control.getAccessibleContext().setAccessibleDescription(text());
  }

  /** The same in lines, as tooltips do not break them. */
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

  /** Makes all in a component be about this topic, unless it is about one of its own. */
  public void mark(JComponent component) {
    component.putClientProperty(PROPERTY, this);
  }

  /** The topic of a component, or of what it stands in. */
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
