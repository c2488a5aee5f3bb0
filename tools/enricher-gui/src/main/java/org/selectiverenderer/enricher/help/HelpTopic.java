package org.selectiverenderer.enricher.help;

import java.awt.Component;
import java.awt.Container;
import java.util.Optional;
import javax.swing.JComponent;

/** What the help can explain. A control says by a property which topic it is about. */
public enum HelpTopic {
  SWITCH(
      "Switch: an object in versions",
      "Each choice of a Switch is a version of one object, with more or fewer "
          + "polygons. State for each in which schemas it is shown. The renderer shows the "
          + "version that belongs to the schema that the viewer entered last. Usually the "
          + "version with all polygons has the degree low, the one with the fewest the "
          + "degree high"),
  SENSOR(
      "ProximitySensor: an area",
      "The box of a ProximitySensor is an area of the scene. State which schemas "
          + "become active when the viewer enters it and which when the viewer leaves it"),
  TYPE("Type (consistencyType)", HelpTexts.TYPE),
  DEGREE("Degree (degreeOfConsistency)", HelpTexts.DEGREE),
  SCHEMAS("Schemas (schemaBelonginess)", HelpTexts.SCHEMAS),
  ENTER("On entering (enterTimeSchema)", HelpTexts.ENTER),
  EXIT("On leaving (exitTimeSchema)", HelpTexts.EXIT);

  /** Letters of a line of a tooltip. */
  private static final int LINE = 50;

  private static final String PROPERTY = "enricher.helpTopic";

  private final String title;
  private final String text;

  HelpTopic(String title, String text) {
    this.title = title;
    this.text = text;
  }

  public String title() {
    return title;
  }

  /** What it means, as sentences without the last full stop. */
  public String text() {
    return text;
  }

  /** Makes a control one about this topic: its tooltip, and what the help shows with it. */
  public void explain(JComponent control) {
    mark(control);
    control.setToolTipText(lines(text)); // Not markup, which would be read aloud.
    control.getAccessibleContext().setAccessibleDescription(text);
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
