package org.selectiverenderer.runtime.loading;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.runtime.nodes.sound.AudioClipNode;
import org.selectiverenderer.runtime.scene.Node;
import org.selectiverenderer.runtime.scene.NodeObserver;
import org.selectiverenderer.runtime.sound.Recording;

/**
 * Gives the AudioClips of a running scene other recordings when their {@code url} or {@code load}
 * changes. The one before is played until the new one arrives; {@code load FALSE} takes it away at
 * once.
 */
final class LiveSounds {
  private final LiveFiles files;
  private final Map<AudioClipNode, Watch> watched = new IdentityHashMap<>();
  private final List<Watch> changed = new ArrayList<>();

  LiveSounds(LiveFiles files) {
    this.files = files;
  }

  void watch(Collection<AudioClipNode> present) {
    if (present.isEmpty() && watched.isEmpty()) {
      return;
    }
    Set<AudioClipNode> now = Collections.newSetFromMap(new IdentityHashMap<>());
    now.addAll(present);
    watched
        .values()
        .removeIf(
            watch -> {
              boolean gone = !now.contains(watch.clip);
              if (gone) {
                watch.clip.removeObserver(watch);
              }
              return gone;
            });
    now.forEach(clip -> watched.computeIfAbsent(clip, Watch::new));
  }

  void update() {
    if (!changed.isEmpty()) {
      List<Watch> now = List.copyOf(changed);
      changed.clear();
      now.forEach(Watch::update);
    }
  }

  /** One AudioClip. */
  private final class Watch implements NodeObserver {
    private final AudioClipNode clip;

    /** The url whose recording it has, or waits for; null for none. */
    private String @Nullable [] requested;

    Watch(AudioClipNode clip) {
      this.clip = clip;
      clip.addObserver(this);
      if (files.fromFile(clip) && clip.bool("load")) {
        requested = clip.strings("url");
      } else {
        changed.add(this);
      }
    }

    @Override
    public void changed(Node node, int field) {
      if (field == clip.urlField() || field == clip.loadField()) {
        changed.add(this);
      }
    }

    void update() {
      String[] url = clip.strings("url");
      if (!clip.bool("load") || url.length == 0) {
        requested = null;
        clip.recording(null);
      } else if (requested != url) {
        requested = url;
        files.sound(clip, found -> arrived(url, found));
      }
    }

    private void arrived(String[] url, Optional<Recording> found) {
      if (requested == url) {
        clip.recording(found.orElse(null));
      }
    }
  }
}
