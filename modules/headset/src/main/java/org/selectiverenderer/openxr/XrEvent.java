package org.selectiverenderer.openxr;

/** An event of the runtime (OpenXR 1.0, 2.22). */
sealed interface XrEvent {
  /** The state of the session has changed. */
  record State(SessionState state) implements XrEvent {}

  /** The runtime is about to end (instance loss pending). */
  record InstanceLoss() implements XrEvent {}

  /** The origin of a reference space is about to change. */
  record Recentred() implements XrEvent {}

  /** The visibility mask has changed ({@code XR_KHR_visibility_mask}). */
  record MaskChanged() implements XrEvent {}

  /** The interaction profile of a hand has changed. */
  record ControllersChanged() implements XrEvent {}

  /** The headset was put on or taken off ({@code XR_EXT_user_presence}). */
  record Presence(boolean there) implements XrEvent {}

  /** Any other event, which is ignored. */
  record Other() implements XrEvent {}
}
