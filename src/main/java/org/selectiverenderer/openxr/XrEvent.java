package org.selectiverenderer.openxr;

/** What a runtime tells a program (OpenXR 1.0, 2.22). */
sealed interface XrEvent {
  /** The session has come to a state. */
  record State(SessionState state) implements XrEvent {}

  /** The runtime is about to end. */
  record InstanceLoss() implements XrEvent {}

  /** The user has set another place or direction for the middle of the space. */
  record Recentred() implements XrEvent {}

  /** Lenses hide something else ({@code XR_KHR_visibility_mask}). */
  record MaskChanged() implements XrEvent {}

  /** Hands hold something else. */
  record ControllersChanged() implements XrEvent {}

  /** The headset was put on or taken off ({@code XR_EXT_user_presence}). */
  record Presence(boolean there) implements XrEvent {}

  /** Something that nobody here asks about. */
  record Other() implements XrEvent {}
}
