package org.selectiverenderer.x3d.url;

import java.util.regex.Pattern;

/**
 * Recognises names of files on another computer. On Windows the mere question whether such a file
 * exists contacts that computer and tells it who the user is, so it must not be asked for a name
 * that somebody else has written.
 */
public final class NetworkShare {
  /** A path that Windows takes for a network share: two slashes or backslashes at its start. */
  private static final Pattern SHARE = Pattern.compile("[/\\\\]{2}.*", Pattern.DOTALL);

  private NetworkShare() {}

  /** Returns whether a name is that of a share of another computer. */
  public static boolean is(String name) {
    return SHARE.matcher(name).matches();
  }
}
