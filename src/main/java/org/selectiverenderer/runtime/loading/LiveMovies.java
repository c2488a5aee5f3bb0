package org.selectiverenderer.runtime.loading;

import java.util.List;
import org.selectiverenderer.base.problem.Problems;
import org.selectiverenderer.runtime.movie.Film;
import org.selectiverenderer.runtime.nodes.sound.MovieTextureNode;

/** Follows the MovieTextures of a running scene and reports those whose decoding has failed. */
final class LiveMovies {
  private final LiveImages images;
  private final Problems problems;
  private List<MovieTextureNode> watched = List.of();

  LiveMovies(LiveImages images, Problems problems) {
    this.images = images;
    this.problems = problems;
  }

  void watch(List<MovieTextureNode> present) {
    watched = present;
  }

  void update() {
    for (MovieTextureNode movie : watched) {
      images.image(movie); // A texture that a script has made starts before it is drawn.
      movie.film().ifPresent(film -> follow(movie, film));
    }
  }

  private void follow(MovieTextureNode movie, Film film) {
    film.nextFrame();
    film.fault()
        .ifPresent(
            clause ->
                problems.error(
                    movie.location(),
                    "the file of the MovieTexture %s; its last picture stays".formatted(clause)));
  }
}
