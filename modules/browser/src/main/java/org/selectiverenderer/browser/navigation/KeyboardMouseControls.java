package org.selectiverenderer.browser.navigation;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.EnumSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.selectiverenderer.apparatus.MouseButton;
import org.selectiverenderer.apparatus.MouseButtonMapping;

/**
 * Converts keys and mouse to motion.
 *
 * <ul>
 *   <li>Up/Down or W/S: forward and backward. Left/Right: turn. A/D: sideways. E/Q: up and down
 *       when flying. Shift: faster.
 *   <li>A mouse button of the {@link MouseButtonMapping} that is held still for {@value #HOLD} s
 *       walks until it is released; moving the mouse meanwhile steers. If the mouse moves before
 *       that, dragging only turns the view, so that the user can look without walking and a click
 *       does not cause a step. Dragging with the middle button always only turns the view.
 *   <li>A click with the left button moves the viewer to the shape under the pointer, if the
 *       navigation type allows it ({@link NavigationCommand#LOOK_AT}).
 *   <li>Wheel: changes the speed permanently, by a quarter per notch.
 *   <li>With {@link #looking} off, as under a head tracker, the mouse does not turn the view, and a
 *       button walks at once even if the mouse moves.
 *   <li>The other keys are {@link NavigationCommand}s.
 * </ul>
 *
 * <p>Key repeats of the toolkit are ignored. Not thread-safe: input must come from the thread that
 * queries the motion.
 */
public final class KeyboardMouseControls implements MotionSource {
  /** Seconds for which a button must be held still before it walks. */
  static final double HOLD = 0.15;

  /** Largest unintended motion of the hand in pixels. */
  static final double STILL = 4;

  /** Rotation of the view per pixel dragged, in radians: a quarter of a degree. */
  static final double LOOK = Math.toRadians(0.25);

  /** Turning speed of an arrow key in radians per second. */
  static final double TURN = Math.toRadians(60);

  private static final double FASTER = 3;
  private static final double NOTCH = 1.25;
  private static final double MOST = 16;

  /** A mouse button that is down. */
  private static final class Press {
    private double held;
    private double dragged;
    private boolean looksOnly;
    private boolean walks;

    /** Returns whether the press was a click: neither held nor dragged. */
    boolean clicks() {
      return !walks && !looksOnly;
    }
  }

  private final MouseButtonMapping mapping;
  private final Set<NavigationKey> keys = EnumSet.noneOf(NavigationKey.class);
  private final Map<MouseButton, Press> presses = new EnumMap<>(MouseButton.class);
  private final List<NavigationCommand> commands = new ArrayList<>();
  private double lookYaw;
  private double lookPitch;
  private double speedFactor = 1;
  private boolean looking = true;
  private double stickForward;
  private double stickRight;
  private double stickTurn;

  public KeyboardMouseControls(MouseButtonMapping mapping) {
    this.mapping = mapping;
  }

  /** Sets whether moving the mouse turns the view; initially it does. */
  public void looking(boolean on) {
    looking = on;
  }

  public void keyDown(NavigationKey key) {
    if (keys.add(key)) {
      command(key);
    }
  }

  public void keyUp(NavigationKey key) {
    keys.remove(key);
  }

  /** Executes the command of a key, if it has one, without the key being pressed. */
  public void command(NavigationKey key) {
    commandOf(key).ifPresent(commands::add);
  }

  private static Optional<NavigationCommand> commandOf(NavigationKey key) {
    return Optional.ofNullable(
        switch (key) {
          case HOME -> NavigationCommand.RESET_VIEWPOINT;
          case END -> NavigationCommand.LAST_VIEWPOINT;
          case PAGE_UP -> NavigationCommand.PREVIOUS_VIEWPOINT;
          case PAGE_DOWN -> NavigationCommand.NEXT_VIEWPOINT;
          case F1 -> NavigationCommand.TOGGLE_OVERLAY;
          case F2 -> NavigationCommand.NEXT_MODE;
          case F3 -> NavigationCommand.TOGGLE_COLLISIONS;
          case F4 -> NavigationCommand.RESET_HEADING;
          case F5 -> NavigationCommand.VIEW_ALL;
          case F11 -> NavigationCommand.TOGGLE_FULL_SCREEN;
          case ESCAPE -> NavigationCommand.LEAVE;
          default -> null;
        });
  }

  public void buttonDown(MouseButton button) {
    if (mapping != MouseButtonMapping.OFF) {
      presses.putIfAbsent(button, new Press());
    }
  }

  public void buttonUp(MouseButton button) {
    Press press = presses.remove(button);
    if (press != null && button == MouseButton.LEFT && looking && press.clicks()) {
      commands.add(NavigationCommand.LOOK_AT);
    }
  }

  /**
   * Reports motion of the mouse; without a button down it has no effect.
   *
   * @param dx the motion to the right in pixels
   * @param dy the motion down in pixels
   */
  public void drag(double dx, double dy) {
    if (presses.isEmpty() || !looking) {
      return;
    }
    for (Press press : presses.values()) {
      press.dragged += Math.hypot(dx, dy);
      if (!press.walks && press.dragged > STILL) {
        press.looksOnly = true;
      }
    }
    lookYaw -= dx * LOOK;
    lookPitch -= dy * LOOK;
  }

  /**
   * Reports that the wheel turned.
   *
   * @param notches the number of notches; positive, away from the user, for faster
   */
  public void wheel(double notches) {
    if (mapping != MouseButtonMapping.OFF) {
      speedFactor = Math.max(1 / MOST, Math.min(MOST, speedFactor * Math.pow(NOTCH, notches)));
    }
  }

  /**
   * Sets the motion that controller thumbsticks request, until the next call.
   *
   * @param forward the forward motion, -1 (backward) to 1
   * @param right the sideways motion, -1 (left) to 1 (right)
   * @param turn the rotation, -1 (right) to 1 (left)
   */
  public void stick(double forward, double right, double turn) {
    stickForward = clamp(forward);
    stickRight = clamp(right);
    stickTurn = clamp(turn);
  }

  /**
   * Turns the viewer at once.
   *
   * @param radians the angle to the left
   */
  public void turnBy(double radians) {
    lookYaw += radians;
  }

  /** Releases all keys and buttons, as when the window loses the keyboard focus. */
  public void releaseAll() {
    keys.clear();
    presses.clear();
  }

  /** Returns the commands since the last call, in order. */
  public List<NavigationCommand> takeCommands() {
    List<NavigationCommand> taken = List.copyOf(commands);
    commands.clear();
    return taken;
  }

  @Override
  public MotionRequest next(double dt) {
    int buttons = 0;
    for (Map.Entry<MouseButton, Press> entry : presses.entrySet()) {
      Press press = entry.getValue();
      press.held += dt;
      press.walks |= !looking || press.held >= HOLD && !press.looksOnly;
      if (press.walks) {
        buttons += mapping.forward(entry.getKey());
      }
    }
    int keyed =
        axis(NavigationKey.UP, NavigationKey.DOWN)
            + axis(NavigationKey.W, NavigationKey.S)
            + buttons;
    double forward = clamp(keyed + stickForward);
    MotionRequest motion =
        new MotionRequest(
            forward,
            clamp(axis(NavigationKey.D, NavigationKey.A) + stickRight),
            axis(NavigationKey.E, NavigationKey.Q),
            clamp(axis(NavigationKey.LEFT, NavigationKey.RIGHT) + stickTurn) * TURN,
            lookYaw,
            lookPitch,
            speedFactor * (keys.contains(NavigationKey.SHIFT) ? FASTER : 1));
    lookYaw = 0;
    lookPitch = 0;
    return motion;
  }

  private int axis(NavigationKey positive, NavigationKey negative) {
    return (keys.contains(positive) ? 1 : 0) - (keys.contains(negative) ? 1 : 0);
  }

  private static double clamp(double value) {
    return Math.max(-1, Math.min(1, value));
  }
}
