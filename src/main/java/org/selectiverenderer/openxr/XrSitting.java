package org.selectiverenderer.openxr;

import java.util.List;
import java.util.Optional;
import java.util.Set;

/** A running session with its spaces, swapchains and actions. */
final class XrSitting implements AutoCloseable {
  private final XrConnection connection;
  private final XrSession session;
  private final XrActions actions;
  private final EyeImages images;
  private final int blendMode;
  private final long head;
  private final long room;
  private final boolean floor;
  private List<HiddenArea> hidden = List.of();
  private List<EyeSight> sights = List.of();

  /**
   * Creates the session.
   *
   * @param binding binding of the OpenGL context, which is current
   */
  XrSitting(XrConnection connection, GraphicsBinding binding, Posture posture) {
    this.connection = connection;
    XrInstance instance = connection.instance();
    PictureSize size = instance.pictures(connection.system()).get(0);
    blendMode = instance.blendMode(connection.system());
    actions = connection.actions();
    session = instance.session(connection.system(), binding);
    try {
      Set<XrSession.SpaceKind> kinds = session.spaceKinds();
      floor = posture == Posture.STANDING && kinds.contains(XrSession.SpaceKind.STAGE);
      head = session.space(XrSession.SpaceKind.VIEW);
      room = session.space(floor ? XrSession.SpaceKind.STAGE : XrSession.SpaceKind.LOCAL);
      images = new EyeImages(session, size);
      actions.attach(session);
      readHidden();
    } catch (XrFailure e) {
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

  EyeImages images() {
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
  List<HiddenArea> hidden() {
    return hidden;
  }

  String controllers() {
    return actions.held();
  }

  /**
   * Returns the frame for a display time, with predicted poses; empty while the poses are unknown.
   */
  Optional<XrFrame> frame(XrSession.FrameTime time) {
    Optional<SpacePose> at = session.locate(head, room, time.display());
    Optional<List<EyeSight>> eyes = session.eyes(room, time.display());
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
    List<EyeSight> relative =
        eyes.get().stream()
            .map(
                eye ->
                    new EyeSight(
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
