package org.cleft;

/** Types of voxels in buffers and raw files. */
public enum VoxelType {
    /** Whole numbers of 8 bits without sign. */
    UINT8(CleftNative.CLEFT_TYPE_UINT8, 1),
    /** Whole numbers of 16 bits without sign. */
    UINT16(CleftNative.CLEFT_TYPE_UINT16, 2),
    /** Whole numbers of 16 bits. */
    INT16(CleftNative.CLEFT_TYPE_INT16, 2),
    /** Whole numbers of 32 bits without sign. */
    UINT32(CleftNative.CLEFT_TYPE_UINT32, 4),
    /** Whole numbers of 32 bits. */
    INT32(CleftNative.CLEFT_TYPE_INT32, 4),
    /** Real numbers, single precision. */
    FLOAT32(CleftNative.CLEFT_TYPE_FLOAT32, 4),
    /** Real numbers, double precision. */
    FLOAT64(CleftNative.CLEFT_TYPE_FLOAT64, 8);

    final int number;
    final int bytes;
    final boolean isWhole;

    VoxelType(int number, int bytes) {
        this.number = number;
        this.bytes = bytes;
        isWhole = number != CleftNative.CLEFT_TYPE_FLOAT32 && number != CleftNative.CLEFT_TYPE_FLOAT64;
    }
}
