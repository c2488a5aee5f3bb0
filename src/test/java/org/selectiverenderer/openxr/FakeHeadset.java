package org.selectiverenderer.openxr;

import java.util.Optional;
import org.joml.Quaterniond;
import org.joml.Vector3d;

/** A headset without hardware, for tests of what uses one. */
public final class FakeHeadset {
  private final FakeRuntime runtime = new FakeRuntime();

  /** It has an eye tracker. */
  public FakeHeadset withEyes() {
    runtime.extensions.add(XrActionBindings.GAZE);
    runtime.eyeGaze = true;
    return this;
  }

  /** Its frames are due a hundred times a second, not at once. */
  public FakeHeadset paced() {
    runtime.pauseNanos = FakeRuntime.PERIOD;
    return this;
  }

  /** The eyes look somewhere, in the frame of the head; or nobody sees them. */
  public void look(Optional<Quaterniond> turn) {
    runtime.gaze = turn.map(eyes -> new SpacePose(new Vector3d(), eyes));
  }

  /** Where the head is. */
  public void head(Vector3d position, Quaterniond orientation) {
    runtime.head = new SpacePose(position, orientation);
  }

  /** It is plugged in, or not. */
  public void plugged(boolean there) {
    runtime.headset = there;
  }

  /** Somebody puts it on. */
  public void wear() {
    runtime.wear();
  }

  /** Finds it. */
  public XrHeadsetFinder search() throws HeadsetUnavailableException {
    return XrHeadsetFinder.begin(runtime);
  }

  /** How many connections to the runtime are open. */
  public int connections() {
    return runtime.open;
  }
}
