package org.selectiverenderer.openxr;

import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;

/**
 * The functions of an OpenXR instance, a connection to the runtime. All throw {@link
 * XrResultException}.
 */
interface XrInstance extends AutoCloseable {
  /** Returns name and version of the runtime. */
  String runtime();

  /**
   * Finds a headset; throws {@link XrResultException#FORM_FACTOR_UNAVAILABLE} if none is connected.
   */
  long system();

  /**
   * The properties of a headset.
   *
   * @param eyeGaze whether it has an eye tracker
   */
  record SystemFacts(String name, boolean position, boolean eyeGaze) {}

  SystemFacts facts(long system);

  /** Returns the recommended sizes of the two pictures, the left eye's first. */
  List<RecommendedImageSize> pictures(long system);

  /** Returns the environment blend mode that the runtime prefers. */
  int blendMode(long system);

  /** Creates a session; the binding's OpenGL context must be current. */
  XrSession session(long system, GraphicsBinding binding);

  /** Returns the next event; empty if there is none. */
  Optional<XrEvent> poll();

  /** Returns the present time by the runtime's clock; empty if it cannot be converted. */
  OptionalLong now();

  /** Creates the action system, before there is a session. */
  XrActionSystem inputs();

  @Override
  void close();
}
