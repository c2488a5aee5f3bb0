package org.selectiverenderer.browser.navigation;

/** The keys used in navigation, independent of the window toolkit. */
public enum NavigationKey {
  UP,
  DOWN,
  LEFT,
  RIGHT,
  W,
  A,
  S,
  D,
  /** Up, when flying. */
  E,
  /** Down, when flying. */
  Q,
  SHIFT,
  HOME,
  END,
  PAGE_UP,
  PAGE_DOWN,
  F1,
  F2,
  F3,
  F4,
  F5,
  F11,
  ESCAPE
}
