package org.selectiverenderer.enricher.preview;

import java.awt.event.ActionEvent;
import java.util.List;
import java.util.function.Consumer;
import javax.swing.AbstractAction;
import javax.swing.Action;
import javax.swing.JComponent;
import javax.swing.KeyStroke;
import org.selectiverenderer.enricher.text.Texts;

/**
 * The key bindings of the preview while the author looks, each with its description for the list of
 * shortcuts. Keys of the walk are consumed before them.
 */
final class PreviewKeyBindings {
  private static final double STEP = Math.toRadians(5);
  private static final double SHIFT = 0.05;

  /** Prefix of the bundle keys that describe the actions. */
  private static final String KEYS = "preview.key.";

  private final JComponent picture;

  PreviewKeyBindings(JComponent picture) {
    this.picture = picture;
  }

  /**
   * @param name the action's name, whose description is in the bundles
   */
  void put(String stroke, String name, Runnable does) {
    picture.getInputMap(JComponent.WHEN_FOCUSED).put(KeyStroke.getKeyStroke(stroke), name);
    Action action = action(does);
    action.putValue(Action.NAME, Texts.of(KEYS + name));
    picture.getActionMap().put(name, action);
  }

  private static Action action(Runnable does) {
    return new AbstractAction() {
      private static final long serialVersionUID = 1L;

      @Override
      public void actionPerformed(ActionEvent event) {
        does.run();
      }
    };
  }

  /**
   * Binds the keys that orbit, pan and zoom, and those that choose versions of the selected object.
   */
  void look(PreviewCanvas view, PreviewThread thread) {
    put("V", "nextVersion", () -> thread.tell(stage -> stage.version(+1)));
    put("shift V", "ownVersion", () -> thread.tell(stage -> stage.version(0)));
    put("ctrl LEFT", "lineLeft", () -> view.line(view.comparison().line() - SHIFT));
    put("ctrl RIGHT", "lineRight", () -> view.line(view.comparison().line() + SHIFT));
    orbit(thread, "LEFT", "turnLeft", orbit -> orbit.turn(STEP, 0));
    orbit(thread, "RIGHT", "turnRight", orbit -> orbit.turn(-STEP, 0));
    orbit(thread, "UP", "turnUp", orbit -> orbit.turn(0, STEP));
    orbit(thread, "DOWN", "turnDown", orbit -> orbit.turn(0, -STEP));
    orbit(thread, "shift LEFT", "shiftLeft", orbit -> orbit.pan(-SHIFT, 0));
    orbit(thread, "shift RIGHT", "shiftRight", orbit -> orbit.pan(SHIFT, 0));
    orbit(thread, "shift UP", "shiftUp", orbit -> orbit.pan(0, SHIFT));
    orbit(thread, "shift DOWN", "shiftDown", orbit -> orbit.pan(0, -SHIFT));
    for (String stroke : List.of("PLUS", "EQUALS", "ADD")) {
      orbit(thread, stroke, "nearer", orbit -> orbit.zoom(1));
    }
    for (String stroke : List.of("MINUS", "SUBTRACT")) {
      orbit(thread, stroke, "farther", orbit -> orbit.zoom(-1));
    }
  }

  private void orbit(PreviewThread thread, String stroke, String name, Consumer<OrbitCamera> does) {
    put(stroke, name, () -> thread.tell(stage -> does.accept(stage.orbit())));
  }
}
