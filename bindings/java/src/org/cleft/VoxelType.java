package org.cleft;

/** Types of voxels in buffers and raw files. */
public enum VoxelType {
    // <constants> made by tools/generate.py from include/cleft/cleft.h
    /** Whole numbers of 8 bits without sign. */
    UINT8(CleftNative.CLEFT_TYPE_UINT8),
    /** Whole numbers of 16 bits without sign. */
    UINT16(CleftNative.CLEFT_TYPE_UINT16),
    /** Whole numbers of 16 bits. */
    INT16(CleftNative.CLEFT_TYPE_INT16),
    /** Whole numbers of 32 bits without sign. */
    UINT32(CleftNative.CLEFT_TYPE_UINT32),
    /** Whole numbers of 32 bits. */
    INT32(CleftNative.CLEFT_TYPE_INT32),
    /** Real numbers, single precision. */
    FLOAT32(CleftNative.CLEFT_TYPE_FLOAT32),
    /** Real numbers, double precision. */
    FLOAT64(CleftNative.CLEFT_TYPE_FLOAT64);
    // </constants>

    final int number;
    final int bytes;
    final boolean isWhole;

    VoxelType(int number) {
        this.number = number;
        bytes = Integer.parseInt(name().replaceAll("\\D", "")) / Byte.SIZE;
        isWhole = number != CleftNative.CLEFT_TYPE_FLOAT32 && number != CleftNative.CLEFT_TYPE_FLOAT64;
    }
}
