package org.selectiverenderer.browser.loading;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.WeakHashMap;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.nodes.sound.AudioClipNode;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.browser.scene.NodeObserver;
import org.selectiverenderer.browser.sound.AudioBuffer;

/**
 * Replaces the recordings of AudioClips in a running scene when their {@code url} or {@code load}
 * changes. The previous recording is played until the new one arrives; {@code load FALSE} removes
 * it at once.
 */
final class AudioClipUpdater {
  private final RunningSceneLoader files;
  private final Map<AudioClipNode, Watch> watched = new IdentityHashMap<>();
  private final List<Watch> changed = new ArrayList<>();

  /**
   * The urls whose recordings clips had or were waiting for when they left the scene; their fields
   * were not observed since.
   */
  private final Map<AudioClipNode, Optional<String[]>> left = new WeakHashMap<>();

  AudioClipUpdater(RunningSceneLoader files) {
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
                watch.leave();
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

  /** The observer of one AudioClip. */
  private final class Watch implements NodeObserver {
    private final AudioClipNode clip;

    /** The url whose recording the clip has or is waiting for; null for none. */
    private String @Nullable [] requested;

    private boolean gone;

    Watch(AudioClipNode clip) {
      this.clip = clip;
      clip.addObserver(this);
      Optional<String[]> had = left.remove(clip);
      if (had != null) {
        requested = had.orElse(null);
        changed.add(this); // The fields may have changed meanwhile.
      } else if (files.fromFile(clip) && clip.bool("load")) {
        requested = clip.strings("url");
      } else {
        changed.add(this);
      }
    }

    /** Stops observing a clip that left the scene; a recording that is being read still arrives. */
    void leave() {
      clip.removeObserver(this);
      left.put(clip, Optional.ofNullable(requested));
      gone = true;
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

    private void arrived(String[] url, Optional<AudioBuffer> found) {
      boolean wanted = !gone || clip.bool("load") && clip.strings("url") == url;
      if (requested == url && wanted) {
        clip.recording(found.orElse(null));
      } else if (gone) {
        left.computeIfPresent(clip, (its, had) -> Optional.empty()); // Read again on return.
      }
    }
  }
}
