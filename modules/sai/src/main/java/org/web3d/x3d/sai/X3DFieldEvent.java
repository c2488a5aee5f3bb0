package org.web3d.x3d.sai;

import java.util.EventObject;
import org.jspecify.annotations.Nullable;

/** Says that a field sent an event; its source is the {@link X3DField}. */
public class X3DFieldEvent extends EventObject {
  private static final long serialVersionUID = 1L;

  /** The time stamp of the event in seconds. */
  protected double timestamp;

  /** What {@link X3DField#setUserData} attached to the field. */
  protected transient @Nullable Object userData;

  /**
   * An event.
   *
   * @param source the field
   * @param time the time stamp in seconds
   * @param data what is attached to the field, or null
   */
  public X3DFieldEvent(Object source, double time, @Nullable Object data) {
    super(source);
    this.timestamp = time;
    this.userData = data;
  }

  /** The time stamp in seconds: the same for all events of a cascade (X3D 4.0, 4.4.8). */
  public double getTime() {
    return timestamp;
  }

  /** What was attached to the field by {@link X3DField#setUserData}, or null. */
  public @Nullable Object getData() {
    return userData;
  }
}
