package org.selectiverenderer.runtime.render.draw;

import com.jogamp.opengl.GL3;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.HashSet;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.runtime.instance.LightInstance;
import org.selectiverenderer.runtime.instance.ShapeInstance;
import org.selectiverenderer.runtime.instance.Surface;
import org.selectiverenderer.runtime.instance.SurfaceDetail;
import org.selectiverenderer.runtime.instance.Texture;
import org.selectiverenderer.runtime.instance.TextureSource;
import org.selectiverenderer.runtime.render.gpu.DetailDefines;
import org.selectiverenderer.runtime.render.gpu.DetailTextures;
import org.selectiverenderer.runtime.render.gpu.GpuTexture;
import org.selectiverenderer.runtime.render.gpu.ShapePrograms;
import org.selectiverenderer.runtime.render.gpu.ShapeVariant;
import org.selectiverenderer.runtime.render.gpu.TextureFilters;
import org.selectiverenderer.runtime.render.mesh.MeshPacker;
import org.selectiverenderer.runtime.render.mesh.VertexLayout;

/**
 * The draw states of shapes with their programs, textures and lights, each kept once however many
 * shapes share it.
 */
final class DrawLooks {
  private static final float[] NO_TRANSFORM = {1, 0, 0, 0, 1, 0, 0, 0, 1};

  private final Map<TextureSource, GpuTexture> textures = new HashMap<>();
  private final ShapePrograms programs = new ShapePrograms();
  private final AuthorPrograms authors = new AuthorPrograms();
  private final Map<State, Integer> ranks = new HashMap<>();
  private final Map<List<LightInstance>, List<LightInstance>> lists = new HashMap<>();
  private final Map<DrawLook, DrawLook> known = new HashMap<>();
  private final TextureFilters filters;
  private long uploads;

  /** A program and texture, by which the drawing order is sorted. */
  private record State(ShapePrograms.Family programs, @Nullable GpuTexture texture) {}

  DrawLooks(TextureFilters filters) {
    this.filters = filters;
  }

  /** Returns the number of textures uploaded since the start. */
  long uploads() {
    return uploads;
  }

  /** Returns one shared list object for all shapes with equal lists. */
  List<LightInstance> shared(List<LightInstance> reaching) {
    return lists.computeIfAbsent(reaching, list -> list);
  }

  /**
   * Returns the draw state of a shape and uploads its texture unless it is there. Equal states are
   * the same object, so that their uniforms are sent once.
   *
   * @param drawn the shape's mesh or a refined one
   * @param reaching the lights that reach it, as returned by {@link #shared}
   */
  DrawLook of(GL3 gl, ShapeInstance shape, Mesh drawn, List<LightInstance> reaching) {
    Surface surface = shape.surface();
    AuthorLook author =
        shape.programs().isEmpty()
            ? null
            : authors.choose(gl, shape, drawn, source -> texture(gl, source));
    if (author != null) {
      return authored(gl, shape, drawn, reaching, author);
    }
    if (surface.detail() != null && drawn.primitive() == Mesh.Primitive.TRIANGLES) {
      return detailed(gl, shape, surface.detail(), drawn, reaching);
    }
    Texture image = surface.glow() == null ? surface.texture() : surface.glow();
    GpuTexture texture =
        image == null
                || drawn.texCoords() == null
                || drawn.primitive() == Mesh.Primitive.LINES // Lengths along the line.
            ? null
            : texture(gl, image);
    boolean blended = blended(surface, drawn, texture);
    ShapeVariant variant = variant(drawn, surface, texture, blended, List.of());
    float[] transform = surface.textureTransform();
    DrawLook look =
        new DrawLook(
            programs.get(variant),
            programs.get(variant.lit(true)),
            texture,
            reaching,
            new Numbers(numbers(surface)),
            new Numbers(transform == null ? NO_TRANSFORM : transform),
            blended,
            VertexLayout.of(drawn),
            shape.stroke(),
            shape.surroundings(),
            drawn.primitive(),
            drawn.solid(),
            null,
            null);
    return known.computeIfAbsent(look, same -> same);
  }

  private GpuTexture texture(GL3 gl, TextureSource source) {
    return textures.computeIfAbsent(
        source,
        image -> {
          uploads++;
          return new GpuTexture(gl, GeneratedCubes.fitting(image, textures.values()), filters);
        });
  }

  private DrawLook detailed(
      GL3 gl, ShapeInstance shape, SurfaceDetail detail, Mesh drawn, List<LightInstance> reaching) {
    Surface surface = shape.surface();
    List<GpuTexture> images = new ArrayList<>();
    detail.units().forEach(unit -> images.add(texture(gl, unit.source())));
    boolean blended = DetailAlpha.blended(surface, detail, images, MeshPacker.translucent(drawn));
    boolean cutOut = DetailAlpha.cutOut(detail, images);
    ShapeVariant variant =
        variant(
            drawn,
            surface,
            null,
            blended,
            DetailDefines.of(
                detail, surface.tints(), coordinates(drawn), drawn.tangents(), cutOut));
    Surface back = detail.back();
    DetailTextures textured =
        new DetailTextures(
            List.copyOf(images),
            DetailMatrices.of(detail.units(), drawn.bounds()),
            detail.numbers(),
            back == null ? null : numbers(back),
            cutOut || detail.alphaMode() == SurfaceDetail.AlphaMode.MASK);
    ShapePrograms.Family family = programs.get(variant);
    return whole(family, shape, drawn, reaching, blended, textured, null);
  }

  /**
   * Returns the draw state of a shape with a custom shader: only the opacity of its surface counts
   * here.
   */
  private DrawLook authored(
      GL3 gl, ShapeInstance shape, Mesh drawn, List<LightInstance> reaching, AuthorLook author) {
    Surface surface = shape.surface();
    SurfaceDetail detail = surface.detail();
    boolean blended =
        detail == null || detail.alphaMode() == SurfaceDetail.AlphaMode.AUTO
            ? blended(
                surface, drawn, surface.texture() == null ? null : texture(gl, surface.texture()))
            : detail.alphaMode() == SurfaceDetail.AlphaMode.BLEND;
    ShapePrograms.Family family = programs.get(variant(drawn, surface, null, blended, List.of()));
    return whole(family, shape, drawn, reaching, blended, null, author);
  }

  /**
   * Returns a draw state with per-pixel lighting only, whose textures are all in the material
   * binding or the custom shader.
   */
  private DrawLook whole(
      ShapePrograms.Family family,
      ShapeInstance shape,
      Mesh drawn,
      List<LightInstance> reaching,
      boolean blended,
      @Nullable DetailTextures textured,
      @Nullable AuthorLook author) {
    DrawLook look =
        new DrawLook(
            family,
            family,
            null,
            reaching,
            new Numbers(numbers(shape.surface())),
            new Numbers(NO_TRANSFORM),
            blended,
            VertexLayout.of(drawn),
            shape.stroke(),
            shape.surroundings(),
            drawn.primitive(),
            drawn.solid(),
            textured,
            author);
    known.put(look, look);
    return look;
  }

  /** Returns the number of components of each of the mesh's further texture coordinates. */
  private static List<Integer> coordinates(Mesh mesh) {
    return mesh.moreTexCoords().stream()
        .filter(more -> more.name().isEmpty())
        .map(Mesh.TexCoords::components)
        .toList();
  }

  /** Returns the state's place in the drawing order. */
  int rank(DrawLook look) {
    return ranks.computeIfAbsent(new State(look.byPixel(), look.texture()), state -> ranks.size());
  }

  /** Returns the same state for batches whose vertices store the diffuse colour. */
  DrawLook tinted(DrawLook look) {
    return look.drawnBy(programs.tinted(look.byPixel()), programs.tinted(look.byVertex()));
  }

  private static boolean blended(Surface surface, Mesh mesh, @Nullable GpuTexture texture) {
    return surface.transparency() > 0
        || MeshPacker.translucent(mesh)
        || (texture != null
            && surface.glow() == null
            && texture.alpha() == GpuTexture.Alpha.BLENDED);
  }

  private static ShapeVariant variant(
      Mesh mesh,
      Surface surface,
      @Nullable GpuTexture texture,
      boolean blended,
      List<String> detail) {
    Surface back = surface.detail() == null ? null : surface.detail().back();
    boolean shiny = shiny(surface) || (back != null && shiny(back));
    return new ShapeVariant(
        surface.lit() && mesh.normals() != null,
        shiny,
        false,
        mesh.colors() != null,
        texture != null,
        surface.tints(),
        surface.glow() != null,
        texture != null && texture.alpha() == GpuTexture.Alpha.CUT_OUT,
        !mesh.solid(),
        mesh.primitive() == Mesh.Primitive.POINTS,
        blended,
        false,
        detail);
  }

  private static boolean shiny(Surface surface) {
    float[] specular = surface.specular();
    return specular[0] > 0 || specular[1] > 0 || specular[2] > 0;
  }

  private static float[] numbers(Surface surface) {
    float[] d = surface.diffuse();
    float[] e = surface.emissive();
    float[] s = surface.specular();
    return new float[] {
      d[0],
      d[1],
      d[2],
      1 - surface.transparency(),
      e[0],
      e[1],
      e[2],
      surface.ambientIntensity(),
      s[0],
      s[1],
      s[2],
      surface.shininess() * 128
    };
  }

  /** Frees the resources that none of the items uses. */
  void keepOnly(GL3 gl, List<DrawItem> items) {
    Set<GpuTexture> used = new HashSet<>();
    // Compared by identity: each shared list and each state's material array is one object.
    Set<List<LightInstance>> usedLists = Collections.newSetFromMap(new IdentityHashMap<>());
    Set<float[]> usedNumbers = Collections.newSetFromMap(new IdentityHashMap<>());
    for (DrawItem item : items) {
      used.add(item.texture());
      if (item.detail() != null) {
        used.addAll(item.detail().textures());
      }
      if (item.author() != null) {
        item.author().textures().forEach(texture -> texture.ifPresent(used::add));
      }
      usedLists.add(item.lighting().reaching());
      usedNumbers.add(item.numbers());
    }
    lists.values().removeIf(list -> !usedLists.contains(list));
    known.keySet().removeIf(look -> !usedNumbers.contains(look.material().array()));
    textures
        .values()
        .removeIf(
            texture -> {
              boolean unused = !used.contains(texture);
              if (unused) {
                texture.dispose(gl);
              }
              return unused;
            });
    authors.keepOnly(gl, items);
    ranks.keySet().removeIf(state -> state.texture() != null && !used.contains(state.texture()));
  }

  void dispose(GL3 gl) {
    keepOnly(gl, List.of());
    programs.dispose(gl);
  }
}
