package org.selectiverenderer.x3d.field;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

class PackedArrayTest {
  private static int[] grid(int columns, int rows) {
    return IntStream.range(0, columns * rows)
        .flatMap(
            i -> {
              int a = i / columns * (columns + 1) + i % columns;
              return IntStream.of(a, a + 1, a + columns + 2, -1);
            })
        .toArray();
  }

  @Test
  void indicesOfTrianglesArePackedAndComeBack() {
    int[] indices = grid(80, 70);
    Object packed = PackedArray.of(indices);
    assertThat(packed).hasToString("packed array");
    assertThat(PackedArray.read(packed)).isEqualTo(indices);
    assertThat(packed).hasToString("array");
    assertThat(PackedArray.read(packed)).isSameAs(PackedArray.read(packed));
  }

  @Test
  void normalsOfThreeDecimalsArePackedAndComeBackToTheBit() {
    float[] normals = new float[6000];
    Random random = new Random(7);
    for (int i = 0; i < normals.length; i++) {
      normals[i] = (random.nextInt(2001) - 1000) / 1000f;
    }
    normals[17] = -0.0f;
    normals[18] = 0.0f;
    Object packed = PackedArray.of(normals);
    assertThat(packed).isInstanceOf(PackedArray.class);
    assertBits((float[]) PackedArray.read(packed), normals);
  }

  private static void assertBits(float[] actual, float[] expected) {
    assertThat(actual).hasSameSizeAs(expected);
    for (int i = 0; i < expected.length; i++) {
      assertThat(Float.floatToRawIntBits(actual[i]))
          .isEqualTo(Float.floatToRawIntBits(expected[i]));
    }
  }

  @Test
  void smallArraysAndOtherValuesStayAsTheyAre() {
    for (Object value : new Object[] {new int[100], new float[100], "text", 3, new double[9000]}) {
      assertThat(PackedArray.of(value)).isSameAs(value);
    }
    assertThat(PackedArray.read(null)).isNull();
  }

  @Test
  void whatDoesNotGetSmallerStaysAsItIs() {
    int[] random = new Random(1).ints(5000).toArray();
    assertThat(PackedArray.of(random)).isSameAs(random);
    float[] long1 = new float[5000];
    long1[4999] = 0.123456f;
    assertThat(PackedArray.of(long1)).isSameAs(long1);
    for (float odd : new float[] {Float.NaN, Float.POSITIVE_INFINITY, -1e30f, Float.MIN_VALUE}) {
      float[] values = new float[5000];
      values[3000] = odd;
      assertThat(PackedArray.of(values)).isSameAs(values);
    }
  }

  @Test
  void anyArrayComesBackToTheBit() {
    Random random = new Random(42);
    for (int round = 0; round < 300; round++) {
      int length = 2048 + random.nextInt(3000);
      int spread = 1 << random.nextInt(31);
      int[] ints = new int[length];
      float[] floats = new float[length];
      float ten = (float) Math.pow(10, random.nextInt(5));
      for (int i = 0; i < length; i++) {
        boolean far = random.nextInt(40) == 0;
        ints[i] = far ? random.nextInt() : random.nextInt(spread);
        floats[i] = (random.nextInt(1 << 1 + random.nextInt(16)) - 500) / ten;
      }
      ints[random.nextInt(length)] = Integer.MIN_VALUE;
      ints[random.nextInt(length)] = Integer.MAX_VALUE;
      assertThat(PackedArray.read(PackedArray.of(ints))).isEqualTo(ints);
      assertBits((float[]) PackedArray.read(PackedArray.of(floats)), floats);
    }
  }
}
