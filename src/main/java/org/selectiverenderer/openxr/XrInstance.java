package org.selectiverenderer.openxr;

import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;

/** The functions of an instance: a connection to a runtime. All throw {@link XrFailure}. */
interface XrInstance extends AutoCloseable {
  /** The runtime's name and version. */
  String runtime();

  /** Finds a headset. {@link XrFailure#FORM_FACTOR_UNAVAILABLE} when none is connected. */
  long system();

  /**
   * What a headset is.
   *
   * @param eyeGaze whether it tells where the eyes look
   */
  record SystemFacts(String name, boolean position, boolean eyeGaze) {}

  SystemFacts facts(long system);

  /** The two pictures of a headset, the left eye's first. */
  List<PictureSize> pictures(long system);

  /** How its pictures go together with the room around: the runtime's own choice. */
  int blendMode(long system);

  /** Begins a session. The context of the binding is current. */
  XrSession session(long system, GraphicsBinding binding);

  /** The next event; empty when there is none. */
  Optional<XrEvent> poll();

  /** The runtime's present time; empty where it does not say. */
  OptionalLong now();

  /** The actions of the program, before there is a session. */
  XrInputs inputs();

  @Override
  void close();
}
