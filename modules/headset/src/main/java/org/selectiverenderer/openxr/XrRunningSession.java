package org.selectiverenderer.openxr;

import java.util.List;
import java.util.Optional;
import java.util.Set;

/** A running session with its spaces, swapchains and actions. */
final class XrRunningSession implements AutoCloseable {
  private final XrConnection connection;
  private final XrSession session;
  private final XrActionBindings actions;
  private final EyeSwapchains images;
  private final int blendMode;
  private final long head;
  private final long room;
  private final boolean floor;
  private List<VisibilityMask> hidden = List.of();
  private List<XrEyeView> sights = List.of();

  /**
   * Creates the session.
   *
   * @param binding binding of the OpenGL context, which is current
   */
  XrRunningSession(XrConnection connection, GraphicsBinding binding, Posture posture) {
    this.connection = connection;
    XrInstance instance = connection.instance();
    RecommendedImageSize size = instance.pictures(connection.system()).get(0);
    blendMode = instance.blendMode(connection.system());
    actions = connection.actions();
    session = instance.session(connection.system(), binding);
    try {
      Set<XrSession.SpaceKind> kinds = session.spaceKinds();
      floor = posture == Posture.STANDING && kinds.contains(XrSession.SpaceKind.STAGE);
      head = session.space(XrSession.SpaceKind.VIEW);
      room = session.space(floor ? XrSession.SpaceKind.STAGE : XrSession.SpaceKind.LOCAL);
      images = new EyeSwapchains(session, size);
      actions.attach(session);
      readHidden();
    } catch (XrResultException e) {
      session.close();
      throw e;
    }
  }

  /** Returns whether heights are above the real floor. */
  boolean floor() {
    return floor;
  }

  XrSession session() {
    return session;
  }

  EyeSwapchains images() {
    return images;
  }

  /** Reads the visibility masks, at first and when they change. */
  void readHidden() {
    hidden =
        connection.has(XrConnection.MASK)
            ? List.of(session.hidden(0), session.hidden(1))
            : List.of();
  }

  /** Returns the visibility masks, the left eye's first; empty without the extension. */
  List<VisibilityMask> hidden() {
    return hidden;
  }

  String controllers() {
    return actions.held();
  }

  /**
   * Returns the frame for a display time, with predicted poses; empty while the poses are unknown.
   */
  Optional<XrFrame> frame(XrSession.FrameTime time) {
    Optional<XrPose> at = session.locate(head, room, time.display());
    Optional<List<XrEyeView>> eyes = session.eyes(room, time.display());
    if (at.isEmpty() || eyes.isEmpty()) {
      sights = List.of();
      return Optional.empty();
    }
    sights = eyes.get();
    long lead =
        connection.has(XrConnection.CLOCK)
            ? connection.instance().now().stream()
                .map(now -> time.display() - now)
                .findAny()
                .orElse(-1)
            : -1;
    List<XrEyeView> relative =
        eyes.get().stream()
            .map(
                eye ->
                    new XrEyeView(
                        eye.pose().seenFrom(at.get()),
                        eye.left(),
                        eye.right(),
                        eye.bottom(),
                        eye.top()))
            .toList();
    return Optional.of(
        new XrFrame(
            time.display(),
            time.drawn(),
            at.get(),
            relative,
            floor,
            lead,
            actions.read(session, head, time.display())));
  }

  /**
   * Ends a frame.
   *
   * @param shown whether the pictures of both eyes were rendered, with the views of the frame
   */
  void end(long display, boolean shown) {
    images.release();
    boolean pictures = shown && !sights.isEmpty();
    session.endFrame(display, blendMode, room, pictures ? images.pictures(sights) : List.of());
  }

  @Override
  public void close() {
    session.close();
  }
}
